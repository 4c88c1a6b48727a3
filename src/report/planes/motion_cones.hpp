// All motions of a contact problem in space, contact by contact: what each contact does, in its friction cone seen from
// above.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/judge/judge.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// What a contact does in a motion. The place of a range is its middle, or 0 where it holds 0.
struct ContactMotion {
  double normal = 0;                           ///< r_N
  bool lifts = false;                          ///< without a force, u_N > 0
  std::optional<std::array<double, 2>> force;  ///< r_T / (mu r_N), where there are force and friction
  /// The direction of u_T, of length 1, where u_T is not 0 for sure and the contact does not lift.
  std::optional<std::array<double, 2>> slip;
};

/// `lifts`, `slips`, `sticks`; `presses` without friction; `touches` without a force.
std::string_view state_of(const ContactMotion& motion);

struct MotionRow {
  std::string mode;
  std::string_view kind;  ///< `continuum`, `forces open`; empty: one motion by one choice of forces
  bool nearest = false;   ///< its forces are nearest to those of the answer
  std::vector<ContactMotion> contacts;
};

/// The first rows and columns; `motions` and `contacts` count all.
struct MotionCones {
  static constexpr std::size_t most = 12;
  std::size_t motions = 0, contacts = 0;
  std::vector<MotionRow> rows;

  std::size_t columns() const { return std::min(contacts, most); }
};

/// Nothing where not all solutions are known, there are none, or the problem is not one in space with friction.
std::optional<MotionCones> motion_cones(const MixedProblem& problem, const ContactJudgement& judgement);

/// Adds the picture as a last child; needs picture_style() in the document. Its title and description have the ids
/// ID-title and ID-text. data-plot of each contact's group gives the place of (0, 0) and the length of a unit.
Element add_motion_cones(const Element& parent, const MotionCones& cones, const std::string& id);

/// The angle of a direction from r_T1 towards r_T2, in degrees from -180 to 180.
double degrees_of(const std::array<double, 2>& direction);

}  // namespace slipproof
