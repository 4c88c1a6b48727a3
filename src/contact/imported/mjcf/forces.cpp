// What springs, dampers, tendons, fluids and actuators exert at this instant, as MuJoCo sums it up for each joint.
#ifdef SLIPPROOF_MJCF

#include <fmt/format.h>

#include <algorithm>

#include "base/output/listed.hpp"
#include "contact/imported/mjcf/context.hpp"

namespace slipproof::imported {

namespace {

class ForceReader {
 public:
  explicit ForceReader(const MjcfContext& context) : c_(context), m_(context.m), d_(context.d) {}

  void read() {
    for (int j = 0; j < m_.njnt; ++j) joint(j);
    if (!pushed_.empty()) {
      c_.tell(
          "what springs, dampers, tendons, fluids and actuators exert at this instant are forces of their own, on " +
          listed(pushed_));
    }
    actuators();
  }

 private:
  double along(int dof) const { return d_.qfrc_passive[dof] + d_.qfrc_actuator[dof] + d_.qfrc_applied[dof]; }

  void joint(int j) {
    const int dof = m_.jnt_dofadr[j], type = m_.jnt_type[j];
    const int count = type == mjJNT_FREE ? 6 : type == mjJNT_BALL ? 3 : 1;
    bool any = false;
    for (int k = dof; k < dof + count; ++k) any = any || along(k) != 0;
    if (!any) return;
    const int body = m_.jnt_bodyid[j];
    Push push;
    const std::string name = c_.name_of(mjOBJ_JOINT, j, c_.name_of(mjOBJ_BODY, body, "body" + std::to_string(body)));
    push.name = name + "_pushed";
    push.on = c_.number_of[static_cast<std::size_t>(body)];
    push.at = c_.scene.bodies[push.on].at;
    if (type == mjJNT_FREE) {
      push.force = vector_at(dof);
      push.at = c_.poses[static_cast<std::size_t>(body)].at;
      push.couple = c_.poses[static_cast<std::size_t>(body)].turn(vector_at(dof + 3));
    } else if (!between(j, push)) {
      return;
    }
    c_.scene.pushes.push_back(std::move(push));
    pushed_.push_back(name);
  }

  Vector vector_at(int dof) const { return {computed(along(dof)), computed(along(dof + 1)), computed(along(dof + 2))}; }

  /// Between the two bodies of the joint, which may be massless links.
  bool between(int j, Push& push) {
    const int body = m_.jnt_bodyid[j], dof = m_.jnt_dofadr[j];
    const Joint* joint = joint_of(j);
    if (joint == nullptr) return false;
    push.on = joint->second;
    push.back_on = joint->first;
    push.at = joint->at;
    if (joint->kind == Joint::Kind::hinge) push.couple = computed(along(dof)) * joint->axis;
    if (joint->kind == Joint::Kind::slide) push.force = computed(along(dof)) * joint->axis;
    if (joint->kind == Joint::Kind::ball) push.couple = c_.poses[static_cast<std::size_t>(body)].turn(vector_at(dof));
    return true;
  }

  /// The joints of a body stand in the scene in MuJoCo's order, the last one at the body itself.
  const Joint* joint_of(int j) const {
    const int body = m_.jnt_bodyid[j];
    std::size_t steps = static_cast<std::size_t>(m_.body_jntadr[body] + m_.body_jntnum[body] - 1 - j);
    std::size_t second = c_.number_of[static_cast<std::size_t>(body)];
    for (;;) {
      const auto found = std::ranges::find_if(c_.scene.joints, [&](const Joint& joint) {
        return joint.second == second && joint.kind != Joint::Kind::fixed;
      });
      if (found == c_.scene.joints.end()) return nullptr;
      if (steps-- == 0) return &*found;
      second = found->first;
    }
  }

  void actuators() {
    std::vector<std::string> at_rest, pushing;
    for (int i = 0; i < m_.nu; ++i) {
      const std::string name = c_.name_of(mjOBJ_ACTUATOR, i, fmt::format("actuator{}", i + 1));
      (d_.actuator_force[i] == 0 ? at_rest : pushing).push_back(name);
    }
    if (!at_rest.empty()) c_.tell("actuators at rest, which exert nothing here: " + listed(at_rest));
    for (const std::string& name : pushing) {
      c_.scene.only_in_space.push_back({c_.file.place("actuator", ""),
                                        name + ": found an actuator that pushes at this instant, expected one at rest",
                                        ""});
    }
  }

  const MjcfContext& c_;
  const mjModel& m_;
  const mjData& d_;
  std::vector<std::string> pushed_;
};

}  // namespace

void read_forces(const MjcfContext& context) {
  ForceReader(context).read();
}

}  // namespace slipproof::imported

#endif
