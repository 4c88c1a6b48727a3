// What proves that a scene can rest, or cannot, and how that is checked: exactly, and apart from how it was found.
#pragma once

#include <vector>

#include "contact/rest/rest_program.hpp"

namespace slipproof {

/// A virtual motion that no contact resists: at each contact that may push it opens at least mu times as fast as it
/// slips, and all links hold. If it gains power from what pushes, the scene cannot rest: all forces together gain power
/// from it or none, and would have to lose some.
struct VirtualMotion {
  std::vector<Rational> rates;    ///< of each row
  std::vector<Rational> rubbing;  ///< of each limit: at least the speed of its slip
  Rational power;                 ///< of what pushes, without what the limits can take
  bool opens_or_resists =
      false;  ///< some contact or limit could lose power: if power is 0, these must be without force
};

/// The power that a push gains along a motion, without what the limits can take.
Rational power_along(const VirtualMotion& motion, const RestPush& push);

/// Whether forces within the cones and limits balance the push.
bool holds(const RestProblem& problem, const RestPush& push, const std::vector<Rational>& forces);

/// The motion of these multipliers (SparseOptimum::y of a RestProgram, as many as there are rows and limits), scaled so
/// that its largest rate is 1; nothing if a contact or link resists it.
std::optional<VirtualMotion> virtual_motion(const RestProblem& problem, const RestPush& push,
                                            const std::vector<Rational>& multipliers);

}  // namespace slipproof
