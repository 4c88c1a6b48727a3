// Sums of squares: the last technique, where there is a solver (semidefinite.hpp). Products of facts times sums of
// squares, and multiples of equations, that add up to zero, are a contradiction as soon as one of them is strict
// (Putinar's and Schmuedgen's certificates). In a proof each square takes a split on its root.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// Closes a branch; `close` gets those where the root of a square is 0 that was to be strict.
bool refute_by_sums_of_squares(Context& context, State& state, const Close& close);

}  // namespace slipproof::prove
