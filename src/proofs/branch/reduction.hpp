// Reduction: adds a multiple of an equation to a fact so that the fact loses a variable, a product of two, or terms. To
// remove a variable, it first multiplies the fact by a power of the pivot, which must be known to be positive: then the
// result has the same sign.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// Derives a fact of the same sign without the rule's variable (or product), or shorter by its circle, and puts it in
/// place of the fact; nothing happens to one where there is nothing to do.
void reduce(Context& context, State& state, const Rule& rule, Fact& fact);

}  // namespace slipproof::prove
