// SDF, by sdformat: a world, or one model. Poses are put together here, in rationals, from what each element says of
// itself. Gazebo takes the lesser of two coefficients of friction, and 1 where none stands.
#include "contact/imported/gazebo.hpp"
#include "contact/imported/readers.hpp"

#ifdef SLIPPROOF_SDF

#include <fmt/format.h>

#include <sdf/sdf.hh>

namespace slipproof::imported {

namespace {

const Tags tags{{"sdf",
                 "world",
                 "model",
                 "link",
                 "joint",
                 "frame",
                 "pose",
                 "inertial",
                 "mass",
                 "inertia",
                 "ixx",
                 "ixy",
                 "ixz",
                 "iyy",
                 "iyz",
                 "izz",
                 "collision",
                 "geometry",
                 "box",
                 "size",
                 "sphere",
                 "radius",
                 "cylinder",
                 "length",
                 "capsule",
                 "plane",
                 "normal",
                 "surface",
                 "friction",
                 "ode",
                 "mu",
                 "mu2",
                 "axis",
                 "xyz",
                 "limit",
                 "lower",
                 "upper",
                 "effort",
                 "velocity",
                 "dynamics",
                 "damping",
                 "static",
                 "use_parent_model_frame",
                 "gravity",
                 "parent",
                 "child"},
                {"visual",
                 "material",
                 "light",
                 "scene",
                 "physics",
                 "gui",
                 "plugin",
                 "sensor",
                 "audio",
                 "atmosphere",
                 "magnetic_field",
                 "spherical_coordinates",
                 "self_collide",
                 "enable_wind",
                 "allow_auto_disable",
                 "contact",
                 "bounce",
                 "velocity_decay",
                 "must_be_base_link",
                 "max_contacts",
                 "laser_retro",
                 "stiffness",
                 "dissipation",
                 "physics",
                 "spring_reference"}};

Vector vector_of(const ignition::math::Vector3d& v) {
  return {written(v.X()), written(v.Y()), written(v.Z())};
}

class SdfReader {
 public:
  SdfReader(const TaggedFile& file, Scene& scene, Mistakes& mistakes)
      : file_(file), scene_(scene), mistakes_(mistakes) {}

  void read(const sdf::Root& root) {
    if (root.WorldCount() > 1) mistakes_.add(file_.place(file_.root()), "found several worlds, expected one");
    if (const sdf::World* world = root.WorldByIndex(0)) {
      scene_.name = world->Name();
      scene_.gravity = vector_of(world->Gravity());
      if (world->FrameCount() > 0) {
        mistakes_.add(file_.place("frame", world->FrameByIndex(0)->Name()),
                      "found a frame of the world, expected none");
      }
      for (std::uint64_t i = 0; i < world->ModelCount(); ++i) read(*world->ModelByIndex(i));
    } else if (root.Model() != nullptr) {
      scene_.name = root.Model()->Name();
      scene_.gravity = Vector{0, 0, Rational(-98) / 10};
      scene_.import_notes.push_back("a model without a world: gravity is SDF's own, 9.8 along -z");
      read(*root.Model());
    } else {
      mistakes_.add(file_.place(file_.root()), "found neither a world nor a model, expected one");
    }
  }

 private:
  Pose pose_of(const ignition::math::Pose3d& pose, const std::string& whose) {
    const auto& q = pose.Rot();
    return {turn_of({q.W(), q.X(), q.Y(), q.Z()}, whose, scene_), vector_of(pose.Pos())};
  }

  void read(const sdf::Model& model) {
    const Place place = file_.place("model", model.Name());
    if (model.ModelCount() > 0) mistakes_.add(place, model.Name() + ": found a model in a model, expected links");
    if (!model.PoseRelativeTo().empty()) mistakes_.add(place, model.Name() + ": found its pose relative to a frame");
    model_ = &model;
    prefix_ = scene_.name == model.Name() ? "" : model.Name() + "_";
    own_ = pose_of(model.RawPose(), model.Name());
    const std::size_t first = scene_.bodies.size();
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) add(*model.LinkByIndex(i));
    if (!mistakes_.empty()) return;
    for (std::uint64_t i = 0; i < model.JointCount(); ++i) add(*model.JointByIndex(i), first);
    for (std::size_t i = first; model.Static() && i < scene_.bodies.size(); ++i) {
      scene_.joints.push_back({Joint::Kind::fixed, scene_.bodies[i].name, 0, i, {}, {}, 0, {}});
    }
  }

  /// Where something of the model is.
  Pose frame(const std::string& name) {
    if (name.empty() || name == "__model__") return own_;
    if (name == "world") return {};
    if (const sdf::Link* link = model_->LinkByName(name))
      return frame(link->PoseRelativeTo()) * pose_of(link->RawPose(), name);
    if (const sdf::Joint* joint = model_->JointByName(name)) return pose_of(*joint);
    const sdf::Frame* other = model_->FrameByName(name);
    if (other == nullptr) {
      mistakes_.add(file_.place("model", model_->Name()), "found the frame " + in_quotes(name) + " of elsewhere");
      return {};
    }
    return frame(other->PoseRelativeTo().empty() ? other->AttachedTo() : other->PoseRelativeTo()) *
           pose_of(other->RawPose(), name);
  }
  Pose pose_of(const sdf::Joint& joint) {
    return frame(joint.PoseRelativeTo().empty() ? joint.ChildLinkName() : joint.PoseRelativeTo()) *
           pose_of(joint.RawPose(), joint.Name());
  }

  void add(const sdf::Link& link) {
    Body body;
    body.name = prefix_ + link.Name();
    body.place = file_.place("link", link.Name());
    const Pose pose = frame(link.Name());
    const auto& inertial = link.Inertial();
    const Pose centre = pose * pose_of(inertial.Pose(), body.name + ", its inertia");
    body.mass = written(inertial.MassMatrix().Mass());
    body.at = centre.at;
    const auto& m = inertial.MassMatrix();
    body.inertia = turned(
        {written(m.Ixx()), written(m.Iyy()), written(m.Izz()), written(m.Ixy()), written(m.Ixz()), written(m.Iyz())},
        centre.turn);
    if (!link.Element()->HasElement("inertial") && !model_->Static()) {
      scene_.import_notes.push_back(body.name + " has no inertia of its own: SDF's is 1 kg and 1 kg m^2");
    }
    for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) add_shape(body, *link.CollisionByIndex(i), pose);
    if (link.Element()->HasElement("gravity") && !link.Element()->Get<bool>("gravity")) {
      mistakes_.add(body.place, body.name + ": found a link without gravity, expected gravity on all");
    }
    scene_.bodies.push_back(std::move(body));
  }

  void add_shape(Body& body, const sdf::Collision& collision, const Pose& link) {
    Shape shape;
    shape.name = prefix_ + collision.Name();
    shape.place = file_.place("collision", collision.Name());
    const std::string& to = collision.PoseRelativeTo();
    shape.pose = (to.empty() ? link : frame(to)) * pose_of(collision.RawPose(), shape.name);
    read_friction(collision, shape);
    const sdf::Geometry& geometry = *collision.Geom();
    switch (geometry.Type()) {
      case sdf::GeometryType::BOX:
        shape.half = Rational(1, 2) * vector_of(geometry.BoxShape()->Size());
        break;
      case sdf::GeometryType::SPHERE:
        shape.kind = Shape::Kind::sphere;
        shape.radius = written(geometry.SphereShape()->Radius());
        break;
      case sdf::GeometryType::CYLINDER:
        shape.kind = Shape::Kind::cylinder;
        shape.radius = written(geometry.CylinderShape()->Radius());
        shape.half_length = written(geometry.CylinderShape()->Length()) / 2;
        break;
      case sdf::GeometryType::CAPSULE:
        shape.kind = Shape::Kind::capsule;
        shape.radius = written(geometry.CapsuleShape()->Radius());
        shape.half_length = written(geometry.CapsuleShape()->Length()) / 2;
        break;
      case sdf::GeometryType::PLANE:
        return add_plane(body, std::move(shape), vector_of(geometry.PlaneShape()->Normal()));
      default:
        return mistakes_.add(shape.place, shape.name +
                                              ": found another geometry, expected a box, sphere, cylinder, "
                                              "capsule or plane");
    }
    body.shapes.push_back(std::move(shape));
  }

  void add_plane(Body& body, Shape shape, const Vector& normal) {
    shape.kind = Shape::Kind::plane;
    const auto direction = direction_of(shape.pose.turn(normal));
    if (!direction) return mistakes_.add(shape.place, shape.name + ": found a normal whose length is not rational");
    shape.pose.turn.axes[2] = *direction;  // the other two do not matter
    body.shapes.push_back(std::move(shape));
  }

  void read_friction(const sdf::Collision& collision, Shape& shape) {
    const auto down = [](sdf::ElementPtr element, const char* tag) {
      return element && element->HasElement(tag) ? element->GetElement(tag) : nullptr;
    };
    const sdf::ElementPtr ode = down(down(down(collision.Element(), "surface"), "friction"), "ode");
    const auto coefficient = [&](const char* tag) {
      return ode && ode->HasElement(tag) ? written(ode->Get<double>(tag)) : Rational(1);
    };
    shape.mu = std::min(coefficient("mu"), coefficient("mu2"));
    shape.greater_mu = std::max(coefficient("mu"), coefficient("mu2"));
  }

  void add(const sdf::Joint& joint, std::size_t first) {
    Joint result;
    result.name = prefix_ + joint.Name();
    result.place = file_.place("joint", joint.Name());
    const auto body_of = [&](const std::string& name) -> std::size_t {
      if (name == "world") return 0;
      for (std::size_t i = first; i < scene_.bodies.size(); ++i) {
        if (scene_.bodies[i].name == prefix_ + name) return i;
      }
      mistakes_.add(result.place, result.name + ": found the frame " + in_quotes(name) + ", expected a link");
      return 0;
    };
    result.first = body_of(joint.ParentLinkName());
    result.second = body_of(joint.ChildLinkName());
    if (!mistakes_.empty()) return;
    const Pose pose = pose_of(joint);
    result.at = pose.at;
    switch (joint.Type()) {
      case sdf::JointType::FIXED:
        break;
      case sdf::JointType::REVOLUTE:
      case sdf::JointType::CONTINUOUS:
        result.kind = Joint::Kind::hinge;
        break;
      case sdf::JointType::PRISMATIC:
        result.kind = Joint::Kind::slide;
        break;
      default:
        return mistakes_.add(result.place, result.name +
                                               ": found a joint of another type, expected fixed, revolute, "
                                               "continuous or prismatic");
    }
    if (const sdf::JointAxis* axis = joint.Axis(0); axis != nullptr && result.kind != Joint::Kind::fixed) {
      const std::string& in = axis->XyzExpressedIn();
      result.axis = (in.empty() ? pose : frame(in)).turn(vector_of(axis->Xyz()));
      result.friction = written(axis->Friction());
      if (axis->SpringStiffness() != 0) mistakes_.add(result.place, result.name + ": found a spring, expected none");
      if (axis->Lower() >= 0 || axis->Upper() <= 0) {
        mistakes_.add(result.place, result.name + ": found it at a limit, or beyond: a stop is not read");
      } else if (axis->Lower() > -1e15 || axis->Upper() < 1e15) {
        scene_.import_notes.push_back(result.name + ": its limits, which are not reached here, are left out");
      }
    }
    scene_.joints.push_back(std::move(result));
  }

  const TaggedFile& file_;
  Scene& scene_;
  Mistakes& mistakes_;
  const sdf::Model* model_ = nullptr;
  std::string prefix_;
  Pose own_;
};

}  // namespace

void read_sdf(TaggedFile& file, const ReadOptions&, Scene& scene, Mistakes& mistakes) {
  scene.format = "SDF";
  scene.rule = FrictionRule::least;
  const bool has_ground_plane = take_known_includes(file, mistakes);
  scene.import_notes = file.check(tags, mistakes);
  if (has_ground_plane) add_ground_plane(scene);
  const std::string_view version = file.root().attribute("version").value();
  if (version.size() != 3 || version.substr(0, 2) != "1." || version > sdf::SDF::Version()) {
    mistakes.add(file.place(file.root()),
                 "found the version " + in_quotes(version) + " of SDF, expected one up to " + sdf::SDF::Version());
  }
  if (!mistakes.empty()) return;
  sdf::Console::Instance()->SetQuiet(true);
  sdf::Root root;
  for (const sdf::Error& error : root.LoadSdfString(file.rest())) {
    mistakes.add(file.place(file.root()), "sdformat: " + error.Message());
  }
  if (!mistakes.empty()) return;
  SdfReader(file, scene, mistakes).read(root);
}

}  // namespace slipproof::imported

#else

namespace slipproof::imported {

void read_sdf(TaggedFile& file, const ReadOptions&, Scene&, Mistakes& mistakes) {
  mistakes.add(file.place(file.root()), "found SDF, which this program was built without: it needs libsdformat-dev");
}

}  // namespace slipproof::imported

#endif
