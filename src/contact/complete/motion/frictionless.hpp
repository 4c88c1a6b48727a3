// Motions that need no friction: with a symmetric, positive semidefinite W they are the only ones.
//
// Let (r, u) be a motion with r_T = 0, and with u_T = 0 at all contacts with friction, and (r', u') another solution.
// Then (r' - r) . (u' - u) = (r' - r) . W (r' - r) >= 0. At each contact it is r' . u' - r' . u - r . u' + r . u, where
// r . u = 0, r . u' = r_N u'_N >= 0, r' . u = r'_N u_N >= 0 and r' . u' = r'_T . u'_T <= 0, as friction brakes. So it
// is 0, and a semidefinite W then gives W (r' - r) = 0: the velocities are the same. This is how a box stands on level
// ground on any number of feet, and how stacks do, where the tree would divide the directions of each foot.
#pragma once

#include "contact/complete/motion/motion.hpp"

namespace slipproof {

/// The motion with velocities u, by forces without friction: of these forces the one with the greatest least r_N, as
/// long as that is below 1. Nothing if there is none, or if u_T is not 0 at a contact with friction.
std::optional<SpatialMotion> motion_without_friction(const ExactContacts& contacts, std::span<const Rational> u);

/// factor * (form . r)^2
struct WeightedSquare {
  Rational factor;
  std::vector<Rational> form;
};

/// W as a sum of squares with positive factors; nothing unless it is symmetric and semidefinite. Cubic in its size.
std::optional<std::vector<WeightedSquare>> squares_of(const RationalMatrix& W);

}  // namespace slipproof
