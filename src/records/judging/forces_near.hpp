// Forces that a motion leaves open, near given ones.
#pragma once

#include <optional>
#include <vector>

#include "contact/space/solved_space.hpp"

namespace slipproof {

/// Forces of a motion, in the order of force_names(), that differ little from the given ones; the law holds for them
/// exactly. Nothing of a motion in which a contact slips, and where what was tried breaks the law: there may be others.
/// A force is nothing where links that say the same leave it open.
std::optional<std::vector<std::optional<Rational>>> forces_near(const SolvedSpace& solved, const SpaceMotion& motion,
                                                                const std::vector<Rational>& given);

}  // namespace slipproof
