// Which bicycles and forces a claim speaks of.
#pragma once

#include <vector>

#include "claims/sampling/solved_sample.hpp"

namespace slipproof {

/// The forces at which a claim says something about a sample, by its region, its `forces` and the motions that there
/// are; what an interval or an equivalence says of one force, it says of all. `compiled` is made from `file`, the
/// sample from the claim's setting. Empty where it says nothing, or where its region or its forces have no value.
std::vector<ForceInterval> reach(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                 SolvedSample& sample);

}  // namespace slipproof
