// The conditions of a mode, in a box around a zero of its equations.
#pragma once

#include <vector>

#include "contact/enclosure/enclosure.hpp"

namespace slipproof {

/// The contacts whose conditions the box does not decide. Where some do not hold strictly the box is not locally unique
/// any more.
std::vector<std::size_t> check_conditions(const MixedProblem& problem, Enclosure& box);

}  // namespace slipproof
