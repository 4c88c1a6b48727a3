// Which comparison of a claim is false at a counterexample, and what its two sides are there.
#pragma once

#include <vector>

#include "claims/verify/verify.hpp"

namespace slipproof {

/// The comparisons that make the claim false at the force of the example, with both sides: of `holds` in the mode of
/// the judgement; of an equivalence, those of the side that is false. Empty where a continuum, a negation or a claim of
/// another kind leaves none to name. The sample is the example's.
std::vector<BrokenComparison> broken_comparisons(const Claim& claim, Reading reading, const CompiledSetting& setting,
                                                 const Counterexample& example, SolvedSample& sample);

}  // namespace slipproof
