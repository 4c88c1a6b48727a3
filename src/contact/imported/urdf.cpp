// URDF, by urdfdom: one robot. It has neither ground nor gravity nor friction, and whether its first link is held
// somewhere it does not say, unless that link is called `world`.
#include "contact/imported/mesh.hpp"
#include "contact/imported/readers.hpp"

#ifdef SLIPPROOF_URDF

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <mutex>

namespace slipproof::imported {

namespace {

const Tags tags{
    {"robot", "link", "joint", "inertial", "origin", "mass", "inertia", "collision", "geometry", "box", "sphere",
     "cylinder", "mesh", "parent", "child", "axis", "limit", "dynamics"},
    {"visual", "material", "transmission", "gazebo", "sensor", "calibration", "safety_controller", "verbose"},
    {"mimic"}};

/// What urdfdom says is wrong, which it tells a console that all of the process shares. One at a time.
class Console : public console_bridge::OutputHandler {
 public:
  Console() : alone_(mutex_) { console_bridge::useOutputHandler(this); }
  ~Console() override { console_bridge::restorePreviousOutputHandler(); }
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && said_.empty()) said_ = text;
  }
  const std::string& said() const { return said_; }

 private:
  static inline std::mutex mutex_;
  std::lock_guard<std::mutex> alone_;
  std::string said_;
};

class UrdfReader {
 public:
  UrdfReader(const TaggedFile& file, const ReadOptions& options, Scene& scene, Mistakes& mistakes)
      : file_(file), options_(options), scene_(scene), mistakes_(mistakes) {}

  void read(const urdf::ModelInterface& robot) {
    scene_.name = robot.getName();
    const urdf::LinkConstSharedPtr root = robot.getRoot();
    add(*root, Pose());
    if (scene_.bodies.size() != robot.links_.size() + 1) {
      mistakes_.add(file_.place(file_.root()), "found links that no chain of joints holds to " + root->name);
    }
    if (root->name == "world") {
      scene_.joints.push_back({Joint::Kind::fixed, "world", 0, 1, {}, {}, 0, {}});
    } else {
      scene_.import_notes.push_back(root->name + ", the first link, is held by nothing: call it `world` to fix it");
    }
  }

 private:
  static Vector vector_of(const urdf::Vector3& v) { return {written(v.x), written(v.y), written(v.z)}; }
  Pose pose_of(const urdf::Pose& pose, const std::string& whose) {
    const urdf::Rotation& q = pose.rotation;
    return {turn_of({q.w, q.x, q.y, q.z}, whose, scene_), vector_of(pose.position)};
  }

  void add(const urdf::Link& link, const Pose& pose) {
    Body body;
    body.name = link.name;
    body.place = file_.place("link", link.name);
    body.at = pose.at;
    if (link.inertial) {
      const Pose centre = pose * pose_of(link.inertial->origin, link.name + ", its inertia");
      body.mass = written(link.inertial->mass);
      body.at = centre.at;
      const urdf::Inertial& i = *link.inertial;
      body.inertia =
          turned({written(i.ixx), written(i.iyy), written(i.izz), written(i.ixy), written(i.ixz), written(i.iyz)},
                 centre.turn);
    }
    for (const urdf::CollisionSharedPtr& collision : link.collision_array) add_shape(body, *collision, pose);
    const std::size_t own = scene_.bodies.size();
    scene_.bodies.push_back(std::move(body));
    for (const urdf::JointSharedPtr& joint : link.child_joints) {
      const Pose child = tidy(pose * pose_of(joint->parent_to_joint_origin_transform, joint->name));
      add_joint(*joint, child, own);
      for (const urdf::LinkSharedPtr& next : link.child_links) {
        if (next->name == joint->child_link_name) add(*next, child);
      }
    }
  }

  void add_shape(Body& body, const urdf::Collision& collision, const Pose& pose) {
    Shape shape;
    shape.name = collision.name.empty() ? body.name : collision.name;
    shape.place = body.place;
    shape.pose = pose * pose_of(collision.origin, shape.name);
    if (!collision.geometry) return mistakes_.add(body.place, body.name + ": found a collision without a geometry");
    if (const auto* box = dynamic_cast<const urdf::Box*>(collision.geometry.get())) {
      shape.kind = Shape::Kind::box;
      shape.half = Rational(1, 2) * vector_of(box->dim);
    } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(collision.geometry.get())) {
      shape.kind = Shape::Kind::sphere;
      shape.radius = written(sphere->radius);
    } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(collision.geometry.get())) {
      shape.kind = Shape::Kind::cylinder;
      shape.radius = written(cylinder->radius);
      shape.half_length = written(cylinder->length) / 2;
    } else if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(collision.geometry.get())) {
      if (!read_mesh(mesh->filename, vector_of(mesh->scale), options_, shape, scene_, mistakes_)) return;
    }
    body.shapes.push_back(std::move(shape));
  }

  void add_joint(const urdf::Joint& joint, const Pose& pose, std::size_t parent) {
    Joint result;
    result.name = joint.name;
    result.place = file_.place("joint", joint.name);
    result.first = parent;
    result.second = scene_.bodies.size();
    result.at = pose.at;
    result.axis = pose.turn(vector_of(joint.axis));
    if (joint.dynamics) result.friction = written(joint.dynamics->friction);
    switch (joint.type) {
      case urdf::Joint::REVOLUTE:
      case urdf::Joint::CONTINUOUS:
        result.kind = Joint::Kind::hinge;
        break;
      case urdf::Joint::PRISMATIC:
        result.kind = Joint::Kind::slide;
        break;
      case urdf::Joint::FIXED:
        break;
      case urdf::Joint::FLOATING:
        return;  // holds nothing
      default:
        return mistakes_.add(result.place, joint.name +
                                               ": found a joint of another type, expected revolute, continuous, "
                                               "prismatic, fixed or floating");
    }
    if (joint.limits && joint.type != urdf::Joint::FIXED && joint.limits->lower != joint.limits->upper) {
      note_limits(result, joint.limits->lower < 0 && joint.limits->upper > 0, scene_);
    }
    scene_.joints.push_back(std::move(result));
  }

  const TaggedFile& file_;
  const ReadOptions& options_;
  Scene& scene_;
  Mistakes& mistakes_;
};

}  // namespace

void read_urdf(TaggedFile& file, const ReadOptions& options, Scene& scene, Mistakes& mistakes) {
  scene.format = "URDF";
  file.check(tags, scene, mistakes);
  if (!mistakes.empty()) return;
  const Console console;
  const urdf::ModelInterfaceSharedPtr robot = urdf::parseURDF(file.rest());
  if (!robot || !robot->getRoot() || !console.said().empty()) {
    return mistakes.add(file.place(file.root()),
                        "found no robot that urdfdom understands, expected one: " + console.said());
  }
  UrdfReader(file, options, scene, mistakes).read(*robot);
}

}  // namespace slipproof::imported

#else

namespace slipproof::imported {

void read_urdf(TaggedFile& file, const ReadOptions&, Scene&, Mistakes& mistakes) {
  mistakes.add(file.place(file.root()), "found URDF, which this program was built without: it needs liburdfdom-dev");
}

}  // namespace slipproof::imported

#endif
