// Polynomials as other programs read them: with integer coefficients.
#pragma once

#include <utility>
#include <vector>

#include "prove/polynomial.hpp"

namespace slipproof {

/// The least positive integer k for which k p has integer coefficients.
inline Integer common_denominator(const prove::Polynomial& p) {
  Integer result = 1;
  for (const prove::Term& term : p.terms()) result = lcm(result, denominator(term.coefficient));
  return result;
}

}  // namespace slipproof
