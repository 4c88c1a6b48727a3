// What a search of a mechanism in space finds at a point.
#pragma once

#include "mechanics/search/found_motions.hpp"

namespace slipproof {

/// All motions there, by their modes; `undecided` where it is not proved within some seconds that these are all, or
/// that they exist. Another that is near a motion counts as this one. Throws NoValue where solve_space() throws
/// InputError, and std::runtime_error in a build without Clp.
FoundMotions found_in_space(const Mechanism& mechanism, const MechanismValues& values);

}  // namespace slipproof
