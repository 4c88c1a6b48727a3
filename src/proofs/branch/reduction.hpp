// Reduction: a multiple of an equation is added to a fact so that it loses a variable, or a product of two. Of a
// variable the fact is multiplied by a power of the pivot first, which assumes that the pivot is known to be positive:
// then what comes out is of the same sign.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// Derives a fact of the same sign without the rule's variable (or product), and puts it in place of the fact; nothing
/// happens to one without it.
void reduce(Context& context, State& state, const Rule& rule, Fact& fact);

}  // namespace slipproof::prove
