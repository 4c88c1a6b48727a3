// Finds which comparison of a claim is false at a counterexample, and the values of its two sides there.
#pragma once

#include <vector>

#include "claims/verify/verify.hpp"

namespace slipproof {

/// The comparisons that make the claim false at the force of the example, with both sides: those of `holds` in the mode
/// of the judgement; for an equivalence, those of the side that is false. Empty if there is no comparison to name, as
/// for a continuum, a negation, or a claim of another kind. The sample must be the example's.
std::vector<BrokenComparison> broken_comparisons(const Claim& claim, Reading reading, const CompiledSetting& setting,
                                                 const Counterexample& example, SolvedSample& sample);

}  // namespace slipproof
