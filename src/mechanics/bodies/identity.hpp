// Whether an expression of a mechanism is 0 whatever its symbols are.
#pragma once

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof::bodies_in_motion {

/// True: it is 0 for all parameters and angles at which it has a value, as a polynomial identity in the parameters and
/// in t = tan(angle/2), with cos = (1 - t^2)/(1 + t^2) and sin = 2 t/(1 + t^2): this leaves out the angle of half a
/// turn alone, where it holds by continuity. False: it is not, or that is not known: a function occurs, or the
/// polynomials grow too long.
bool vanishes_identically(const Mechanism& mechanism, const Expression& expression);

}  // namespace slipproof::bodies_in_motion
