// MJCF, by MuJoCo, which makes a model of the file: included files, defaults, masses from densities, `fromto`,
// composites. It takes the greater of two coefficients of friction. Its contacts are soft; here they are hard.
#include "contact/imported/readers.hpp"

#ifdef SLIPPROOF_MJCF

#include <fmt/format.h>

#include <algorithm>

#include "base/output/listed.hpp"
#include "contact/imported/mjcf/context.hpp"

namespace slipproof::imported {

namespace {

/// The model at the keyframe, or in its default configuration at rest: places, velocities and forces of its own.
Data state_of(const mjModel& m, const TaggedFile& file, const ReadOptions& options, Scene& scene, Mistakes& mistakes) {
  Data data(mj_makeData(&m));
  std::vector<std::string> keys;
  for (int i = 0; i < m.nkey; ++i) {
    const char* name = mj_id2name(&m, mjOBJ_KEY, i);
    keys.emplace_back(name != nullptr && *name != '\0' ? name : std::to_string(i));
  }
  const auto found = std::ranges::find(keys, options.key);
  if (!options.key.empty() && found == keys.end()) {
    mistakes.add(file.place(file.root()), "found no keyframe " + in_quotes(options.key) +
                                              ", expected one of: " + (keys.empty() ? "none" : listed(keys)));
    return nullptr;
  }
  if (found != keys.end()) mj_resetDataKeyframe(&m, data.get(), static_cast<int>(found - keys.begin()));
  if (found == keys.end() && !keys.empty()) {
    scene.import_notes.push_back("the default configuration, at rest; the file has the keyframes " + listed(keys) +
                                 " (--key)");
  }
  mj_kinematics(&m, data.get());
  mj_comPos(&m, data.get());
  mj_tendon(&m, data.get());
  mj_transmission(&m, data.get());
  mj_fwdVelocity(&m, data.get());
  mj_fwdActuation(&m, data.get());
  return data;
}

class MjcfReader {
 public:
  explicit MjcfReader(MjcfContext& context) : c_(context), m_(context.m), d_(context.d), scene_(context.scene) {}

  void read() {
    scene_.gravity = c_.vector_of(m_.opt.gravity);
    check_options();
    c_.poses.emplace_back();
    c_.exact.push_back(true);
    c_.number_of.push_back(0);
    for (int i = 1; i < m_.nbody; ++i) add_body(i);
    std::vector<std::string> near;
    for (std::size_t i = 1; i < c_.exact.size(); ++i) {
      if (!c_.exact[i]) near.push_back(body_name(static_cast<int>(i)));
    }
    if (!near.empty()) {
      c_.tell("turned by no rational turn: " + listed(near) +
              "; rational ones within 1e-14 rad of MuJoCo's are taken, and 15 places of what lies in them");
    }
    read_geoms(c_);
    read_couplings(c_);
    read_forces(c_);
    c_.tell("MuJoCo computed lengths, masses and inertias; 15 digits of each are taken");
    c_.tell("MuJoCo's contacts are soft, those of the scene hard");
  }

 private:
  std::string body_name(int i) const { return c_.name_of(mjOBJ_BODY, i, "body" + std::to_string(i)); }

  void check_options() {
    const Place place = c_.file.place(c_.file.root());
    constexpr int harmless = mjDSBL_WARMSTART | mjDSBL_FILTERPARENT | mjDSBL_CLAMPCTRL | mjDSBL_SENSOR;
    if ((m_.opt.disableflags & mjDSBL_GRAVITY) != 0) scene_.gravity = Vector{};
    if ((m_.opt.disableflags & ~harmless) != 0) {
      scene_.only_in_space.push_back({place, "found disabled parts of the physics, expected all of them",
                                      "disabled parts of the physics are as they would be without <flag>; of "
                                      "gravity, springs, dampers and actuators what the flags leave"});
    }
    if (m_.opt.density != 0 || m_.opt.viscosity != 0) {
      scene_.only_in_space.push_back({place, "found a fluid, expected none", ""});
    }
  }

  /// The pose from the file's numbers, if they give it exactly at this instant.
  void place_body(int i) {
    const auto parent = static_cast<std::size_t>(m_.body_parentid[i]);
    const int first = m_.body_jntadr[i], count = m_.body_jntnum[i];
    bool exact = c_.exact[parent];
    Pose pose;
    if (m_.body_mocapid[i] >= 0 || (count > 0 && m_.jnt_type[first] == mjJNT_FREE)) {
      exact = true;
      const mjtNum* at = count > 0 ? d_.qpos + m_.jnt_qposadr[first] : d_.mocap_pos + 3 * m_.body_mocapid[i];
      const mjtNum* q = count > 0 ? at + 3 : d_.mocap_quat + 4 * m_.body_mocapid[i];
      pose = local(at, q, exact);
    } else {
      pose = c_.poses[parent] * local(m_.body_pos + 3 * i, m_.body_quat + 4 * i, exact);
      const Turn turn = pose.turn;
      for (int j = first; j < first + count; ++j) {
        const int address = m_.jnt_qposadr[j];
        if (m_.jnt_type[j] == mjJNT_SLIDE) {
          pose.at = pose.at + computed(d_.qpos[address] - m_.qpos0[address]) * turn(c_.vector_of(m_.jnt_axis + 3 * j));
        } else {
          const int size = m_.jnt_type[j] == mjJNT_BALL ? 4 : 1;
          exact = exact && std::equal(d_.qpos + address, d_.qpos + address + size, m_.qpos0 + address);
        }
      }
    }
    exact = exact && tidy(pose).turn.axes == pose.turn.axes;
    if (!exact)
      pose = {rational_turn({d_.xquat[4 * i], d_.xquat[4 * i + 1], d_.xquat[4 * i + 2], d_.xquat[4 * i + 3]}).turn,
              c_.placed_at(d_.xpos + 3 * i)};
    c_.poses.push_back(pose);
    c_.exact.push_back(exact);
  }
  static Pose local(const mjtNum* at, const mjtNum* q, bool& exact) {
    const RationalTurn turn = rational_turn({q[0], q[1], q[2], q[3]});
    exact = exact && turn.error == 0;
    return {turn.turn, MjcfContext::vector_of(at)};
  }

  void add_body(int i) {
    place_body(i);
    Body body;
    body.name = body_name(i);
    body.place = c_.file.place("body", body.name);
    body.mass = computed(m_.body_mass[i]);
    bool exact = c_.exact.back();
    const Pose centre = c_.poses.back() * local(m_.body_ipos + 3 * i, m_.body_iquat + 4 * i, exact);
    body.at = exact ? centre.at : c_.placed_at(d_.xipos + 3 * i);
    const Vector inertia = c_.vector_of(m_.body_inertia + 3 * i);
    body.inertia = exact ? turned({inertia.x, inertia.y, inertia.z, 0, 0, 0}, centre.turn) : computed_inertia(i);
    add_joints(i, std::move(body));
  }

  Inertia computed_inertia(int i) const {
    const mjtNum *r = d_.ximat + 9 * i, *principal = m_.body_inertia + 3 * i;
    const auto entry = [&](int a, int b) {
      double sum = 0;
      for (int k = 0; k < 3; ++k) sum += r[3 * a + k] * principal[k] * r[3 * b + k];
      return computed(sum);
    };
    return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
  }

  /// Adds the body behind the massless links that stand between its joints.
  void add_joints(int i, Body body) {
    const std::size_t parent = c_.number_of[static_cast<std::size_t>(m_.body_parentid[i])];
    const int count = m_.body_jntnum[i], first = m_.body_jntadr[i];
    if (count == 0) return add_fixed(i, std::move(body), parent);
    if (m_.jnt_type[first] == mjJNT_FREE) return add_free(first, std::move(body));
    std::size_t holder = parent;
    for (int j = first; j < first + count; ++j) {
      Joint joint = joint_of(j, holder, body.name);
      Body next = std::move(body);
      if (j + 1 < first + count) {
        body = std::move(next);
        next = Body();
        next.name = body.name + "_after_" + joint.name;
        next.place = joint.place;
        next.at = joint.at;
        next.massless = true;
      }
      joint.second = add(std::move(next));
      add_motion(joint, j);
      holder = joint.second;
      scene_.joints.push_back(std::move(joint));
    }
    c_.number_of.push_back(holder);
    if (count > 1) note_chain(i, parent, first, count);
  }

  std::size_t add(Body body) {
    scene_.bodies.push_back(std::move(body));
    return scene_.bodies.size() - 1;
  }

  void add_fixed(int i, Body body, std::size_t parent) {
    if (m_.body_mocapid[i] >= 0) {
      scene_.only_in_space.push_back({body.place, "found a body that is moved from outside, expected none",
                                      body.name + " is moved from outside: here it stands still"});
    }
    const Body& whole = scene_.bodies[parent];
    body.spin = whole.spin;
    body.velocity = whole.velocity + cross(whole.spin, body.at - whole.at);
    const std::string name = body.name;
    scene_.joints.push_back({Joint::Kind::fixed, name, parent, add(std::move(body)), {}, {}, 0, {}, 0});
    c_.number_of.push_back(scene_.bodies.size() - 1);
  }

  Joint joint_of(int j, std::size_t first, const std::string& owner) {
    const int body = m_.jnt_bodyid[j], dof = m_.jnt_dofadr[j];
    Joint joint;
    joint.name = c_.name_of(mjOBJ_JOINT, j, owner + "_joint");
    joint.place = c_.file.place("joint", joint.name);
    joint.kind = m_.jnt_type[j] == mjJNT_HINGE   ? Joint::Kind::hinge
                 : m_.jnt_type[j] == mjJNT_SLIDE ? Joint::Kind::slide
                                                 : Joint::Kind::ball;
    joint.first = first;
    const Pose& pose = c_.poses[static_cast<std::size_t>(body)];
    const bool exact = c_.exact[static_cast<std::size_t>(body)];
    joint.at = exact ? pose(c_.vector_of(m_.jnt_pos + 3 * j)) : c_.placed_at(d_.xanchor + 3 * j);
    const mjtNum* axis = d_.xaxis + 3 * j;
    joint.axis = exact ? pose.turn(c_.vector_of(m_.jnt_axis + 3 * j)) : Vector{};
    if (!direction_of(joint.axis)) joint.axis = unit_near({axis[0], axis[1], axis[2]});
    joint.friction = computed(m_.dof_frictionloss[dof]);
    joint.armature = computed(m_.dof_armature[dof]);
    check_joint(j, joint);
    return joint;
  }

  void check_joint(int j, const Joint& joint) {
    const auto only_in_space = [&](const std::string& found, const std::string& left_out) {
      scene_.only_in_space.push_back({joint.place, joint.name + ": found " + found, left_out});
    };
    if (joint.kind == Joint::Kind::ball) only_in_space("a ball joint, expected a hinge or a slide", "");
    if (!joint.armature.is_zero()) only_in_space("an armature, expected none", "");
    const int at = m_.jnt_qposadr[j];
    if (m_.jnt_stiffness[j] != 0 && d_.qpos[at] != m_.qpos_spring[at]) {
      only_in_space("a spring under tension, expected one that is slack", "");
    }
    if (joint.kind == Joint::Kind::ball && !joint.friction.is_zero()) {
      only_in_space("friction in a ball joint", joint.name + ": its friction is left out");
    }
    if (m_.jnt_limited[j] == 0) return;
    const bool reached = joint.kind != Joint::Kind::ball &&
                         (d_.qpos[at] <= m_.jnt_range[2 * j] || d_.qpos[at] >= m_.jnt_range[2 * j + 1]);
    note_limits(joint, !reached, scene_);
  }

  /// A free body with an armature has that of a point at its origin, which has no weight.
  void add_free(int j, Body body) {
    const int dof = m_.jnt_dofadr[j];
    const Pose& pose = c_.poses[static_cast<std::size_t>(m_.jnt_bodyid[j])];
    body.spin = pose.turn(c_.vector_of(d_.qvel + dof + 3));
    if (const Rational armature = computed(m_.dof_armature[dof]); !armature.is_zero()) {
      scene_.only_in_space.push_back({body.place, body.name + ": found an armature, expected none", ""});
      Body point;
      point.mass = armature;
      point.at = pose.at;
      point.inertia = {armature, armature, armature, 0, 0, 0};
      add_to(body, point);
      scene_.pushes.push_back(
          {body.name + "_armature_has_no_weight", scene_.bodies.size(), 0, -armature * *scene_.gravity, pose.at, {}});
      c_.tell(fmt::format("{}: its armature {} is a mass without weight at its origin, and an inertia", body.name,
                          armature.str()));
    }
    body.velocity = c_.vector_of(d_.qvel + dof) + cross(body.spin, body.at - pose.at);
    c_.number_of.push_back(add(std::move(body)));
  }

  /// The velocity of a joint's second body from its first.
  void add_motion(const Joint& joint, int j) {
    const Body& first = scene_.bodies[joint.first];
    Body& second = scene_.bodies[joint.second];
    const mjtNum* rate = d_.qvel + m_.jnt_dofadr[j];
    second.spin = first.spin;
    Vector at_joint = first.velocity + cross(first.spin, joint.at - first.at);
    if (joint.kind == Joint::Kind::hinge) second.spin = second.spin + computed(rate[0]) * joint.axis;
    if (joint.kind == Joint::Kind::slide) at_joint = at_joint + computed(rate[0]) * joint.axis;
    if (joint.kind == Joint::Kind::ball) {
      second.spin = second.spin + c_.poses[static_cast<std::size_t>(m_.jnt_bodyid[j])].turn(c_.vector_of(rate));
    }
    second.velocity = at_joint + cross(second.spin, second.at - joint.at);
  }

  /// Two slides with a hinge are a body that is free in a plane; the scene in a plane takes them together again.
  void note_chain(int i, std::size_t parent, int first, int count) {
    const Body& body = scene_.bodies[c_.number_of[static_cast<std::size_t>(i)]];
    if (parent != 0) scene_.excluded.emplace_back(parent, c_.number_of[static_cast<std::size_t>(i)]);
    const auto hinges = std::count(m_.jnt_type + first, m_.jnt_type + first + count, static_cast<int>(mjJNT_HINGE));
    const auto slides = std::count(m_.jnt_type + first, m_.jnt_type + first + count, static_cast<int>(mjJNT_SLIDE));
    if (count == 3 && slides == 2 && hinges == 1) return;
    scene_.only_in_space.push_back(
        {body.place, body.name + ": found several joints, expected one, or two slides and a hinge", ""});
  }

  MjcfContext& c_;
  const mjModel& m_;
  const mjData& d_;
  Scene& scene_;
};

bool moves(const Scene& scene) {
  return std::ranges::any_of(scene.bodies,
                             [](const Body& body) { return !(body.velocity == Vector{} && body.spin == Vector{}); });
}

}  // namespace

void read_mjcf(TaggedFile& file, const ReadOptions& options, Scene& scene, Mistakes& mistakes) {
  scene.format = "MJCF";
  scene.name = file.root().attribute("model").value();
  scene.rule = FrictionRule::greatest;
  const Model model = load_model(file, options, scene, mistakes);
  if (!model) return;
  const Data data = state_of(*model, file, options, scene, mistakes);
  if (!data) return;
  MjcfContext context{file, *model, *data, scene, mistakes, {}, {}, {}};
  MjcfReader(context).read();
  if (moves(scene))
    scene.only_in_space.push_back({file.place(file.root()), "found velocities, expected a scene at rest", ""});
}

}  // namespace slipproof::imported

#else

namespace slipproof::imported {

void read_mjcf(TaggedFile& file, const ReadOptions&, Scene&, Mistakes& mistakes) {
  mistakes.add(file.place(file.root()), "found MJCF, which this program was built without: it needs libmujoco-dev");
}

}  // namespace slipproof::imported

#endif
