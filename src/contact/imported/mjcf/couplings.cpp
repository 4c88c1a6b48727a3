// What couples bodies beside their joints: equality constraints, and pairs that do not touch.
#ifdef SLIPPROOF_MJCF

#include <fmt/format.h>

#include <cmath>

#include "contact/imported/mjcf/context.hpp"

namespace slipproof::imported {

namespace {

class CouplingReader {
 public:
  explicit CouplingReader(const MjcfContext& context) : c_(context), m_(context.m), d_(context.d) {}

  void read() {
    for (int i = 0; i < m_.neq; ++i) {
      if (m_.eq_active[i] != 0) equality(i);
    }
    for (int i = 0; i < m_.nexclude; ++i) {
      const auto pair = static_cast<unsigned>(m_.exclude_signature[i]);
      // Both count from 1 there.
      c_.scene.excluded.emplace_back(number(static_cast<int>(pair >> 16U) - 1),
                                     number(static_cast<int>(pair & 0xffffU) - 1));
    }
    if (m_.npair > 0) c_.tell("pairs that the file says touch are found by their shapes, with these' friction");
    tendons();
  }

 private:
  std::size_t number(int body) const { return c_.number_of[static_cast<std::size_t>(body)]; }

  void equality(int i) {
    const int a = m_.eq_obj1id[i], b = m_.eq_obj2id[i];
    const std::string name = c_.name_of(mjOBJ_EQUALITY, i, fmt::format("equality{}", i + 1));
    const Place place = c_.file.place("equality", "");
    const auto only_in_space = [&](const std::string& left_out) {
      c_.scene.only_in_space.push_back({place, name + ": found an equality constraint, expected none", left_out});
    };
    switch (m_.eq_type[i]) {
      case mjEQ_CONNECT:
        only_in_space("");
        return connect(name, place, a, b, m_.eq_data + mjNEQDATA * i);
      case mjEQ_WELD:
        only_in_space("");
        c_.scene.joints.push_back({Joint::Kind::fixed, name, number(a), number(b), {}, {}, 0, place, 0});
        return;
      case mjEQ_JOINT:
        if (b < 0) return hold(name, place, a);
        return only_in_space(name + ": an equation between the joints " + joint_name(a) + " and " + joint_name(b) +
                             " is left out");
      default:
        return only_in_space(name + ": an equation between the lengths of tendons is left out");
    }
  }

  std::string joint_name(int j) const { return c_.name_of(mjOBJ_JOINT, j, "joint" + std::to_string(j + 1)); }

  /// A ball joint in the middle between both places.
  void connect(const std::string& name, const Place& place, int a, int b, const mjtNum* data) {
    Joint joint;
    joint.kind = Joint::Kind::ball;
    joint.name = name;
    joint.place = place;
    joint.first = number(a);
    joint.second = number(b);
    std::array<mjtNum, 3> first{}, second{}, middle{};
    mju_rotVecMat(first.data(), data, d_.xmat + 9 * a);
    mju_addTo3(first.data(), d_.xpos + 3 * a);
    mju_rotVecMat(second.data(), data + 3, d_.xmat + 9 * b);
    mju_addTo3(second.data(), d_.xpos + 3 * b);
    mju_add3(middle.data(), first.data(), second.data());
    mju_scl3(middle.data(), middle.data(), 0.5);
    joint.at = c_.placed_at(middle.data());
    if (const double apart = mju_dist3(first.data(), second.data()); apart > 1e-12) {
      c_.tell(fmt::format("{}: its two places are {:.2g} apart, and meet here in the middle", name, apart));
    }
    c_.scene.joints.push_back(std::move(joint));
  }

  /// A joint that is held where it is: its two bodies are one.
  void hold(const std::string& name, const Place& place, int j) {
    const std::size_t second = number(m_.jnt_bodyid[j]);
    for (const Joint& joint : c_.scene.joints) {
      if (joint.second != second || joint.name != joint_name(j)) continue;
      c_.scene.only_in_space.push_back({place, name + ": found an equality constraint, expected none", ""});
      c_.scene.joints.push_back({Joint::Kind::fixed, name, joint.first, joint.second, {}, {}, 0, place, 0});
      return;
    }
    c_.scene.only_in_space.push_back({place, name + ": found an equality constraint, expected none",
                                      name + ": an equation that holds the joint " + joint_name(j) + " is left out"});
  }

  /// The forces of tendons are among those at this instant; what only holds is not.
  void tendons() {
    for (int i = 0; i < m_.ntendon; ++i) {
      const std::string name = c_.name_of(mjOBJ_TENDON, i, fmt::format("tendon{}", i + 1));
      const Place place =
          c_.file.place("fixed", name).line != 0 ? c_.file.place("fixed", name) : c_.file.place("spatial", name);
      const double length = d_.ten_length[i];
      const bool reached =
          m_.tendon_limited[i] != 0 && (length <= m_.tendon_range[2 * i] || length >= m_.tendon_range[2 * i + 1]);
      std::string left_out = name + ": a tendon, of which only the force at this instant is taken";
      if (reached) left_out += "; it is at the end of its length, and does not hold here";
      if (m_.tendon_frictionloss[i] != 0) left_out += "; its friction is left out";
      c_.scene.only_in_space.push_back({place, name + ": found a tendon, expected none", left_out});
    }
  }

  const MjcfContext& c_;
  const mjModel& m_;
  const mjData& d_;
};

}  // namespace

void read_couplings(const MjcfContext& context) {
  CouplingReader(context).read();
}

}  // namespace slipproof::imported

#endif
