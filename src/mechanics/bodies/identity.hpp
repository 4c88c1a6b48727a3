// Expressions of a mechanism as rational functions of its parameters and angles: whether one is identically 0, and the
// root of a square.
#pragma once

#include <optional>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof::bodies_in_motion {

/// True: it is 0 for all parameters and angles at which it has a value, as a polynomial identity in the parameters and
/// in t = tan(angle/2), with cos = (1 - t^2)/(1 + t^2) and sin = 2 t/(1 + t^2): this leaves out the angle of half a
/// turn alone, where it holds by continuity. False: it is not, or that is not known: a function occurs, or the
/// polynomials grow too long.
bool vanishes_identically(const Mechanism& mechanism, const Expression& expression);

/// The nonnegative root of an expression that is the square of a rational function of parameters, cosines and sines: l
/// for (l*c)^2 + (l*s)^2. Nothing if it is not a square, or if that is not known, for the same reasons as above.
std::optional<Expression> root_of_square(const Mechanism& mechanism, const Expression& square);

/// The same as a quotient in lowest terms, of polynomials in parameters, cosines and sines, if that is shorter; as it
/// is where a function occurs, or the polynomials grow too long.
Expression shortened(const Mechanism& mechanism, const Expression& expression);

}  // namespace slipproof::bodies_in_motion
