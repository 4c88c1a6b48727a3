// Linear elimination: an equation in which a variable occurs to the first power, with a coefficient of known sign,
// takes that variable out of all other facts; so does one that says what a product of two variables is. If
// the attempt is to use circles, their equations shorten facts: bodies at an angle bring sums of the squares of a
// cosine and a sine.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// Whether p = 0 is the equation of a circle around 0, as of a cosine and a sine: its squares have the coefficient 1 or
/// -1.
bool is_circle(const Polynomial& p);

/// Eliminates with every equation that allows it, variables from `first` on only; true if the state is contradictory
/// then, its steps end in the contradiction.
bool eliminate(Context& context, State& state, std::size_t first = 0);

}  // namespace slipproof::prove
