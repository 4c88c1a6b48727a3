// The bicycles and forces that a claim is about.
#pragma once

#include <vector>

#include "claims/paper/compiled.hpp"
#include "mechanics/family/solved_sample.hpp"

namespace slipproof {

/// The forces at which a claim says something about a sample, by its region, its `forces` and the motions that exist.
/// An interval or an equivalence says something about all forces. `compiled` must be made from `file`, the sample from
/// the claim's setting. Empty if the claim says nothing, or if its region or its forces have no value.
std::vector<ForceInterval> reach(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                 SolvedSample& sample);

}  // namespace slipproof
