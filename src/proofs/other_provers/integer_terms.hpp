// Polynomials as other programs read them: with integer coefficients.
#pragma once

#include "base/algebra/polynomial.hpp"

namespace slipproof {

/// The least positive integer k for which k p has integer coefficients.
inline Integer common_denominator(const MultiPolynomial& p) {
  Integer result = 1;
  for (const Term& term : p.terms()) result = lcm(result, denominator(term.coefficient));
  return result;
}

}  // namespace slipproof
