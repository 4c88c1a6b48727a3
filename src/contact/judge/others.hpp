// Solutions elsewhere than the one that is near an answer.
#pragma once

#include "contact/judge/judge.hpp"

namespace slipproof {

/// Looks in all modes whose equations are linear (exact/linear_modes.hpp) for a solution that is not the known one:
/// `other_exact`. Where the known one leaves forces undetermined, only one with other velocities counts. Sets
/// `linear_modes`, whether they were tried: they are not if that is more work than `allowed`. Requires Coulomb's law
/// and a known solution.
void look_in_linear_modes(const MixedProblem& problem, Work allowed, ContactJudgement& judgement);

}  // namespace slipproof
