// What a search of a mechanism in space finds at a point.
#pragma once

#include "mechanics/search/search.hpp"

namespace slipproof {

/// The mechanism whose motions are searched, with what `options` need for it: in space the load is a parameter, and
/// an impact has a contact that approaches. Throws InputError for an impact that has none, and for one in space by
/// Poisson's law.
Mechanism mechanism_to_search(Mechanism mechanism, SearchOptions& options);

/// All motions there, by their modes, and whether an impact gains energy; `undecided` where it is not proved within
/// some seconds that these are all, or that they exist. Another that is near a motion counts as this one. Throws
/// NoValue where solve_space() throws InputError, and std::runtime_error in a build without Clp.
FoundMotions found_in_space(const Mechanism& mechanism, const MechanismValues& values);

}  // namespace slipproof
