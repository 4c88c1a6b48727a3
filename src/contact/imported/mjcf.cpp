// MJCF, by MuJoCo, which makes a model of the file: defaults, masses from densities, `fromto`. It takes the greater of
// two coefficients of friction. Its contacts are soft; here they are hard.
#include "contact/imported/readers.hpp"

#ifdef SLIPPROOF_MJCF

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstring>
#include <memory>

namespace slipproof::imported {

namespace {

const Tags tags{
    {"mujoco", "compiler", "option", "default", "worldbody", "body", "inertial", "joint", "freejoint", "geom", "motor",
     "flag"},
    {"visual", "statistic", "asset", "site", "camera", "light", "sensor", "keyframe", "size", "custom", "actuator"}};

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
using Model = std::unique_ptr<mjModel, DeleteModel>;

void say_nothing(const char*) {}

/// Null with a message for what MuJoCo does not understand.
Model load(const std::string& text, std::string& message) {
  mju_user_warning = say_nothing;  // or it writes a file of its own
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const char* name = "scene.xml";
  if (mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(text.size())) != 0) return nullptr;
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), name)], text.data(), text.size());
  std::array<char, 1000> error{};
  Model model(mj_loadXML(name, files.get(), error.data(), static_cast<int>(error.size())));
  mj_deleteFileVFS(files.get(), name);
  message = error.data();
  return model;
}

/// Tells that motors exert nothing, refuses what holds or pushes, and takes the names of materials away, which are left
/// out with the materials.
void check_attributes(const TaggedFile& file, pugi::xml_node node, Mistakes& mistakes) {
  node.remove_attribute("material");
  for (pugi::xml_node child : node.children()) {
    const std::string_view tag = child.name();
    if (tag == "geom" && (child.attribute("mesh") || child.attribute("hfield"))) {
      mistakes.add(file.place(child),
                   "found a mesh or a height field, expected a box, sphere, cylinder, capsule or plane");
    }
    if (tag == "body" && child.attribute("mocap")) {
      mistakes.add(file.place(child), "found a body that is moved from outside, expected none");
    }
    check_attributes(file, child, mistakes);
  }
}

void check_actuators(const TaggedFile& file, Mistakes& mistakes) {
  for (const pugi::xml_node actuators : file.root().children("actuator")) {
    for (const pugi::xml_node actuator : actuators.children()) {
      if (actuator.type() == pugi::node_element && std::string_view(actuator.name()) != "motor") {
        mistakes.add(file.place(actuator), std::string("found the actuator <") + actuator.name() +
                                               ">, which may push without being asked to, expected motors");
      }
    }
  }
}

class MjcfReader {
 public:
  MjcfReader(const TaggedFile& file, const mjModel& model, Scene& scene, Mistakes& mistakes)
      : file_(file), m_(model), scene_(scene), mistakes_(mistakes) {}

  void read() {
    scene_.gravity = vector_of(m_.opt.gravity);
    const Place place = file_.place(file_.root());
    if (m_.opt.disableflags != 0) mistakes_.add(place, "found disabled parts of the physics, expected all of them");
    if (m_.opt.density != 0 || m_.opt.viscosity != 0) mistakes_.add(place, "found a fluid, expected none");
    poses_.emplace_back();
    for (int i = 1; i < m_.nbody; ++i) add_body(i);
    bool margin = false;
    for (int i = 0; i < m_.ngeom; ++i) {
      add_shape(i);
      margin = margin || m_.geom_margin[i] > m_.geom_gap[i];
    }
    if (margin)
      scene_.import_notes.emplace_back("a margin, within which MuJoCo's contacts push softly from afar, is left out");
    scene_.import_notes.emplace_back("MuJoCo computed lengths, masses and inertias; 15 digits of each are taken");
    scene_.import_notes.emplace_back("MuJoCo's contacts are soft, those of the scene hard");
  }

 private:
  template <class Number>
  static Vector vector_of(const Number* v) {
    return {computed(v[0]), computed(v[1]), computed(v[2])};
  }
  Pose pose_of(const mjtNum* at, const mjtNum* q, const std::string& whose) {
    return {turn_of({q[0], q[1], q[2], q[3]}, whose, scene_), vector_of(at)};
  }
  std::string name_of(mjtObj kind, int id, const std::string& otherwise) const {
    const char* name = mj_id2name(&m_, kind, id);
    return name != nullptr && *name != '\0' ? name : otherwise;
  }

  void add_body(int i) {
    Body body;
    body.name = name_of(mjOBJ_BODY, i, "body" + std::to_string(i));
    body.place = file_.place("body", body.name);
    const auto parent = static_cast<std::size_t>(m_.body_parentid[i]);
    poses_.push_back(poses_[parent] * pose_of(m_.body_pos + 3 * i, m_.body_quat + 4 * i, body.name));
    const Pose centre =
        poses_.back() * pose_of(m_.body_ipos + 3 * i, m_.body_iquat + 4 * i, body.name + ", its inertia");
    body.mass = computed(m_.body_mass[i]);
    body.at = centre.at;
    const Vector inertia = vector_of(m_.body_inertia + 3 * i);
    body.inertia = turned({inertia.x, inertia.y, inertia.z, 0, 0, 0}, centre.turn);
    const std::size_t own = scene_.bodies.size();
    scene_.bodies.push_back(std::move(body));
    add_joints(i, parent, own);
  }

  /// A body without a joint is fixed to its parent. One with two slides and a hinge across them is free in a plane,
  /// which is told; MuJoCo knows no other way to say that.
  void add_joints(int body, std::size_t parent, std::size_t own) {
    const Body& whole = scene_.bodies[own];
    const int count = m_.body_jntnum[body], first = m_.body_jntadr[body];
    if (count == 0) return scene_.joints.push_back({Joint::Kind::fixed, whole.name, parent, own, {}, {}, 0, {}});
    if (count == 3) {
      int slides = 0, hinges = 0;
      for (int j = first; j < first + 3; ++j) {
        slides += m_.jnt_type[j] == mjJNT_SLIDE ? 1 : 0;
        hinges += m_.jnt_type[j] == mjJNT_HINGE ? 1 : 0;
        check_joint(j, name_of(mjOBJ_JOINT, j, whole.name));
      }
      if (slides == 2 && hinges == 1) {
        scene_.import_notes.push_back(whole.name + " slides along two axes and turns: it is free in their plane");
        return;
      }
    }
    if (count > 1) {
      return mistakes_.add(whole.place, whole.name + ": found several joints, expected one, or two slides and a hinge");
    }
    add_joint(first, parent, own);
  }

  void check_joint(int j, const std::string& name) {
    const Place place = file_.place("joint", name);
    const int dof = m_.jnt_dofadr[j];
    if (m_.dof_armature[dof] != 0) mistakes_.add(place, name + ": found an armature, expected none");
    if (m_.jnt_stiffness[j] != 0 && m_.qpos0[m_.jnt_qposadr[j]] != m_.qpos_spring[m_.jnt_qposadr[j]]) {
      mistakes_.add(place, name + ": found a spring under tension, expected one that is slack");
    }
    if (m_.jnt_limited[j] == 0) return;
    const double at = m_.qpos0[m_.jnt_qposadr[j]];
    if (at <= m_.jnt_range[2 * j] || at >= m_.jnt_range[2 * j + 1]) {
      mistakes_.add(place, name + ": found it at a limit, or beyond: a stop is not read");
    } else {
      scene_.import_notes.push_back(name + ": its limits, which are not reached here, are left out");
    }
  }

  void add_joint(int j, std::size_t parent, std::size_t own) {
    Joint joint;
    joint.name = name_of(mjOBJ_JOINT, j, scene_.bodies[own].name + "_joint");
    joint.place = file_.place("joint", joint.name);
    if (m_.jnt_type[j] == mjJNT_FREE) return;
    if (m_.jnt_type[j] == mjJNT_BALL) {
      return mistakes_.add(joint.place, joint.name + ": found a ball joint, expected a hinge or a slide");
    }
    joint.kind = m_.jnt_type[j] == mjJNT_HINGE ? Joint::Kind::hinge : Joint::Kind::slide;
    joint.first = parent;
    joint.second = own;
    const Pose& pose = poses_[own];
    joint.at = pose(vector_of(m_.jnt_pos + 3 * j));
    joint.axis = pose.turn(vector_of(m_.jnt_axis + 3 * j));
    joint.friction = computed(m_.dof_frictionloss[m_.jnt_dofadr[j]]);
    check_joint(j, joint.name);
    scene_.joints.push_back(std::move(joint));
  }

  void add_shape(int i) {
    const auto owner = static_cast<std::size_t>(m_.geom_bodyid[i]);
    Body& body = scene_.bodies[owner];
    Shape shape;
    shape.name = name_of(mjOBJ_GEOM, i, owner == 0 ? "floor" : body.name);
    shape.place = file_.place("geom", shape.name);
    if (shape.place.line == 0) shape.place = body.place;
    shape.pose = poses_[owner] * pose_of(m_.geom_pos + 3 * i, m_.geom_quat + 4 * i, shape.name);
    shape.mu = m_.geom_condim[i] == 1 ? Rational(0) : computed(m_.geom_friction[3 * i]);
    shape.kinds = static_cast<unsigned>(m_.geom_contype[i]);
    shape.meets = static_cast<unsigned>(m_.geom_conaffinity[i]);
    const mjtNum* size = m_.geom_size + 3 * i;
    switch (m_.geom_type[i]) {
      case mjGEOM_PLANE:
        shape.kind = Shape::Kind::plane;
        break;
      case mjGEOM_BOX:
        shape.half = vector_of(size);
        break;
      case mjGEOM_SPHERE:
        shape.kind = Shape::Kind::sphere;
        shape.radius = computed(size[0]);
        break;
      case mjGEOM_CYLINDER:
      case mjGEOM_CAPSULE:
        shape.kind = m_.geom_type[i] == mjGEOM_CYLINDER ? Shape::Kind::cylinder : Shape::Kind::capsule;
        shape.radius = computed(size[0]);
        shape.half_length = computed(size[1]);
        break;
      default:
        return mistakes_.add(shape.place, shape.name +
                                              ": found another shape, expected a box, sphere, cylinder, capsule "
                                              "or plane");
    }
    body.shapes.push_back(std::move(shape));
  }

  const TaggedFile& file_;
  const mjModel& m_;
  Scene& scene_;
  Mistakes& mistakes_;
  std::vector<Pose> poses_;  ///< of the bodies
};

}  // namespace

void read_mjcf(TaggedFile& file, Scene& scene, Mistakes& mistakes) {
  scene.format = "MJCF";
  scene.name = file.root().attribute("model").value();
  scene.rule = FrictionRule::greatest;
  check_actuators(file, mistakes);
  scene.import_notes = file.check(tags, mistakes);
  check_attributes(file, file.root(), mistakes);
  if (!mistakes.empty()) return;
  std::string message;
  const Model model = load(file.rest(), message);
  if (!model) return mistakes.add(file.place(file.root()), "MuJoCo: " + message);
  MjcfReader(file, *model, scene, mistakes).read();
}

}  // namespace slipproof::imported

#else

namespace slipproof::imported {

void read_mjcf(TaggedFile& file, Scene&, Mistakes& mistakes) {
  mistakes.add(file.place(file.root()), "found MJCF, which this program was built without: it needs libmujoco-dev");
}

}  // namespace slipproof::imported

#endif
