// Uses that squares are not negative. A certificate shows it by a split on the sign of the base. The squares are
// factors with even exponents, and those from completing the square in an inequality that is quadratic in a variable or
// in a power of one. Each costs a split, so this rule comes last.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

bool close_squares(Context& context, State& state, const Close& close);

}  // namespace slipproof::prove
