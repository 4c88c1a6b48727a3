// A single fact that the others contradict: a strict one that is a multiple of an equation, or an inequality whose
// negation becomes evident when slack variables are substituted (slack.hpp).
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// Looks for one; on success the steps end in the contradiction.
bool refute_single_fact(Context& context, State& state, Pass pass);

}  // namespace slipproof::prove
