// Linear elimination: an equation in which a variable occurs to the first power, with a coefficient of known sign,
// takes that variable out of all other facts; so does one that says what a product of two variables is.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// Eliminates with every equation that allows it, variables from `first` on only; true if the state is contradictory
/// then, its steps end in the contradiction.
bool eliminate(Context& context, State& state, std::size_t first = 0);

}  // namespace slipproof::prove
