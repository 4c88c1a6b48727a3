// SDF, by sdformat: a world, or one model. Poses are put together here, in rationals, from what each element says of
// itself. Gazebo takes the lesser of two coefficients of friction, and 1 where none stands.
#include "contact/imported/gazebo.hpp"
#include "contact/imported/mesh.hpp"
#include "contact/imported/readers.hpp"

#ifdef SLIPPROOF_SDF

#include <fmt/format.h>

#include <map>
#include <sdf/sdf.hh>

namespace slipproof::imported {

namespace {

const Tags tags{
    words_of("sdf world model link joint frame pose inertial mass inertia ixx ixy ixz iyy iyz izz collision geometry "
             "box size sphere radius cylinder length capsule plane mesh uri scale normal surface friction ode mu mu2 "
             "axis axis2 xyz spring_stiffness spring_reference limit lower upper effort velocity dynamics damping "
             "static use_parent_model_frame gravity parent child"),
    words_of("visual material light scene physics gui plugin sensor audio atmosphere magnetic_field "
             "spherical_coordinates self_collide enable_wind allow_auto_disable contact bounce velocity_decay "
             "must_be_base_link max_contacts laser_retro stiffness dissipation"),
    words_of("bullet soft_shape wind actor torsional submesh")};

Vector vector_of(const ignition::math::Vector3d& v) {
  return {written(v.X()), written(v.Y()), written(v.Z())};
}

class SdfReader {
 public:
  SdfReader(const TaggedFile& file, const ReadOptions& options, Scene& scene, Mistakes& mistakes)
      : file_(file), options_(options), scene_(scene), mistakes_(mistakes) {}

  void read(const sdf::Root& root) {
    if (root.WorldCount() > 1) mistakes_.add(file_.place(file_.root()), "found several worlds, expected one");
    if (const sdf::World* world = root.WorldByIndex(0)) {
      scene_.name = world->Name();
      scene_.gravity = vector_of(world->Gravity());
      if (world->FrameCount() > 0) {
        mistakes_.add(file_.place("frame", world->FrameByIndex(0)->Name()),
                      "found a frame of the world, expected none");
      }
      for (std::uint64_t i = 0; i < world->ModelCount(); ++i) read_whole(*world->ModelByIndex(i));
    } else if (root.Model() != nullptr) {
      scene_.name = root.Model()->Name();
      scene_.gravity = Vector{0, 0, Rational(-98) / 10};
      scene_.import_notes.push_back("a model without a world: gravity is SDF's own, 9.8 along -z");
      read_whole(*root.Model());
    } else {
      mistakes_.add(file_.place(file_.root()), "found neither a world nor a model, expected one");
    }
  }

 private:
  Pose pose_of(const ignition::math::Pose3d& pose, const std::string& whose) {
    const auto& q = pose.Rot();
    return {turn_of({q.W(), q.X(), q.Y(), q.Z()}, whose, scene_), vector_of(pose.Pos())};
  }

  void read_whole(const sdf::Model& model) {
    const Place place = file_.place("model", model.Name());
    if (!model.PoseRelativeTo().empty()) mistakes_.add(place, model.Name() + ": found its pose relative to a frame");
    const std::string prefix = scene_.name == model.Name() ? "" : model.Name() + "_";
    const std::size_t first = scene_.bodies.size();
    links_.clear();
    read(model, pose_of(model.RawPose(), model.Name()), prefix, "");
    for (std::size_t i = first; model.Static() && i < scene_.bodies.size(); ++i) {
      scene_.joints.push_back({Joint::Kind::fixed, scene_.bodies[i].name, 0, i, {}, {}, 0, {}, 0});
    }
  }

  /// A model, and those in it: `scope` is what names from outside begin with.
  void read(const sdf::Model& model, const Pose& own, const std::string& prefix, const std::string& scope) {
    model_ = &model;
    own_ = own;
    prefix_ = prefix;
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
      links_[scope + model.LinkByIndex(i)->Name()] = scene_.bodies.size();
      add(*model.LinkByIndex(i));
    }
    for (std::uint64_t i = 0; i < model.ModelCount() && mistakes_.empty(); ++i) {
      const sdf::Model& inner = *model.ModelByIndex(i);
      read(inner, frame_of(model, own, inner.Name()), prefix + inner.Name() + "_", scope + inner.Name() + "::");
      model_ = &model, own_ = own, prefix_ = prefix;
    }
    if (!mistakes_.empty()) return;
    for (std::uint64_t i = 0; i < model.JointCount(); ++i) add(*model.JointByIndex(i), scope);
  }

  /// Where something of the model is.
  Pose frame(const std::string& name) { return frame_of(*model_, own_, name); }

  Pose frame_of(const sdf::Model& model, const Pose& own, const std::string& name) {
    if (name.empty() || name == "__model__") return own;
    if (name == "world") return {};
    const std::size_t end = name.find("::");
    if (const sdf::Model* inner = model.ModelByName(name.substr(0, end))) {
      const Pose pose = frame_of(model, own, inner->PoseRelativeTo()) * pose_of(inner->RawPose(), inner->Name());
      return end == std::string::npos ? pose : frame_of(*inner, pose, name.substr(end + 2));
    }
    if (const sdf::Link* link = model.LinkByName(name)) {
      return tidy(frame_of(model, own, link->PoseRelativeTo()) * pose_of(link->RawPose(), name));
    }
    if (const sdf::Joint* joint = model.JointByName(name)) return pose_of(model, own, *joint);
    const sdf::Frame* other = model.FrameByName(name);
    if (other == nullptr) {
      mistakes_.add(file_.place("model", model.Name()), "found the frame " + in_quotes(name) + " of elsewhere");
      return {};
    }
    return frame_of(model, own, other->PoseRelativeTo().empty() ? other->AttachedTo() : other->PoseRelativeTo()) *
           pose_of(other->RawPose(), name);
  }
  Pose pose_of(const sdf::Model& model, const Pose& own, const sdf::Joint& joint) {
    const std::string& to = joint.PoseRelativeTo();
    return tidy(frame_of(model, own, to.empty() ? joint.ChildLinkName() : to) * pose_of(joint.RawPose(), joint.Name()));
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
      scene_.only_in_space.push_back(
          {body.place, body.name + ": found a link without gravity, expected gravity on all", ""});
      scene_.pushes.push_back(
          {body.name + "_without_gravity", scene_.bodies.size(), 0, -body.mass * *scene_.gravity, body.at, {}});
      scene_.import_notes.push_back(body.name + ": gravity does not act on it: a force takes its weight back");
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
      case sdf::GeometryType::MESH: {
        const sdf::Mesh& mesh = *geometry.MeshShape();
        if (!read_mesh(mesh.Uri(), vector_of(mesh.Scale()), options_, shape, scene_, mistakes_)) return;
        break;
      }
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

  void add(const sdf::Joint& joint, const std::string& scope) {
    Joint result;
    result.name = prefix_ + joint.Name();
    result.place = file_.place("joint", joint.Name());
    std::string parent, child;
    for (const sdf::Error& error : joint.ResolveParentLink(parent))
      mistakes_.add(result.place, "sdformat: " + error.Message());
    for (const sdf::Error& error : joint.ResolveChildLink(child))
      mistakes_.add(result.place, "sdformat: " + error.Message());
    const auto body_of = [&](const std::string& name) { return name == "world" ? 0 : links_.at(scope + name); };
    if (!mistakes_.empty()) return;
    result.first = body_of(parent);
    result.second = body_of(child);
    const Pose pose = pose_of(*model_, own_, joint);
    result.at = pose.at;
    switch (joint.Type()) {
      case sdf::JointType::FIXED:
        return scene_.joints.push_back(std::move(result));
      case sdf::JointType::REVOLUTE:
      case sdf::JointType::CONTINUOUS:
        result.kind = Joint::Kind::hinge;
        return add(std::move(result), joint.Axis(0), pose);
      case sdf::JointType::PRISMATIC:
        result.kind = Joint::Kind::slide;
        return add(std::move(result), joint.Axis(0), pose);
      case sdf::JointType::BALL:
        result.kind = Joint::Kind::ball;
        scene_.only_in_space.push_back({result.place, result.name + another_type, ""});
        return scene_.joints.push_back(std::move(result));
      case sdf::JointType::UNIVERSAL:
      case sdf::JointType::REVOLUTE2:
        return add_two(std::move(result), joint, pose);
      case sdf::JointType::SCREW:
        scene_.import_notes.push_back(result.name + ": a screw, whose thread is left out: it turns and slides freely");
        return add_two(std::move(result), joint, pose);
      default:
        return mistakes_.add(result.place, result.name + another_type);
    }
  }
  static constexpr const char* another_type =
      ": found a joint of another type, expected fixed, revolute, continuous or prismatic";

  /// Two hinges, or the hinge and the slide of a screw, with a massless link between them.
  void add_two(Joint joint, const sdf::Joint& given, const Pose& pose) {
    scene_.only_in_space.push_back({joint.place, joint.name + another_type, ""});
    scene_.excluded.emplace_back(joint.first, joint.second);
    joint.kind = Joint::Kind::hinge;
    Body link;
    link.name = joint.name + "_link";
    link.place = joint.place;
    link.at = joint.at;
    link.massless = true;
    Joint second = joint;
    second.name += "_2";
    const bool screw = given.Type() == sdf::JointType::SCREW;
    if (screw) second.kind = Joint::Kind::slide;
    joint.second = second.first = scene_.bodies.size();
    scene_.bodies.push_back(std::move(link));
    add(std::move(joint), given.Axis(0), pose);
    add(std::move(second), given.Axis(screw ? 0 : 1), pose);
  }

  void add(Joint joint, const sdf::JointAxis* axis, const Pose& pose) {
    if (axis == nullptr) return mistakes_.add(joint.place, joint.name + ": found no axis, expected one");
    const std::string& in = axis->XyzExpressedIn();
    joint.axis = (in.empty() ? pose : frame(in)).turn(vector_of(axis->Xyz()));
    joint.friction = written(axis->Friction());
    add_spring(joint, *axis);
    const bool has_limits = axis->Lower() > -1e15 || axis->Upper() < 1e15;
    if (has_limits) note_limits(joint, axis->Lower() < 0 && axis->Upper() > 0, scene_);
    scene_.joints.push_back(std::move(joint));
  }

  /// What a spring exerts in the configuration of the file, in which the joint is at 0.
  void add_spring(const Joint& joint, const sdf::JointAxis& axis) {
    const Rational now = written(axis.SpringStiffness()) * written(axis.SpringReference());
    if (now.is_zero()) return;
    scene_.only_in_space.push_back({joint.place, joint.name + ": found a spring, expected none", ""});
    scene_.import_notes.push_back(joint.name + ": what its spring exerts at this instant is a force of its own");
    const Vector along = unit_of(joint.axis);
    Push push{joint.name + "_spring", joint.second, joint.first, {}, joint.at, {}};
    (joint.kind == Joint::Kind::slide ? push.force : push.couple) = now * along;
    scene_.pushes.push_back(std::move(push));
  }

  const TaggedFile& file_;
  const ReadOptions& options_;
  Scene& scene_;
  Mistakes& mistakes_;
  const sdf::Model* model_ = nullptr;
  std::string prefix_;
  Pose own_;
  std::map<std::string, std::size_t> links_;  ///< of the whole model, by their names from there
};

}  // namespace

void read_sdf(TaggedFile& file, const ReadOptions& options, Scene& scene, Mistakes& mistakes) {
  scene.format = "SDF";
  scene.rule = FrictionRule::least;
  const bool has_ground_plane = take_known_includes(file, mistakes);
  file.check(tags, scene, mistakes);
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
  SdfReader(file, options, scene, mistakes).read(root);
}

}  // namespace slipproof::imported

#else

namespace slipproof::imported {

void read_sdf(TaggedFile& file, const ReadOptions&, Scene&, Mistakes& mistakes) {
  mistakes.add(file.place(file.root()), "found SDF, which this program was built without: it needs libsdformat-dev");
}

}  // namespace slipproof::imported

#endif
