// Quotients of polynomials, for values of unknowns. They are kept as they come: cancelling takes a factorization.
#pragma once

#include <string>

#include "proofs/branch/context.hpp"

namespace slipproof::prove {

/// numerator / denominator, for a value of an unknown.
struct Quotient {
  Polynomial numerator, denominator;

  std::string text() const;  ///< text in the syntax of certificates
};

Quotient operator/(const Quotient& x, const Quotient& y);

/// x + weight y
Quotient sum(const Quotient& x, const Quotient& y, const Rational& weight);

/// p with a quotient for a variable.
Quotient substituted(const Polynomial& p, std::size_t variable, const Quotient& value);

/// Cancels the common factors of numerator and denominator.
void cancel(Context& context, Quotient& value);

}  // namespace slipproof::prove
