// Squares are not negative, which a certificate shows by a split on the sign of what is squared. The squares here are
// factors of even exponent, and those that completion makes of an inequality that is quadratic in a variable or in a
// power of one. Each costs a split: they come last, when all else has failed.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

bool close_squares(Context& context, State& state, const Close& close);

}  // namespace slipproof::prove
