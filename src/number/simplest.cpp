#include "number/simplest.hpp"

#include <stdexcept>

namespace slipproof {

namespace {

Integer floor_of(const Rational& x) {
  const Integer n = numerator(x), d = denominator(x);
  Integer q = n / d;  // towards zero
  if (n < 0 && q * d != n) --q;
  return q;
}

/// Smallest denominator, then smallest value, strictly between 0 <= lower and upper (no value: infinite).
Rational simplest_positive(const Rational& lower, const std::optional<Rational>& upper) {
  const Integer whole = floor_of(lower);
  const Rational next(whole + 1);
  if (!upper || next < *upper) return next;
  // No integer strictly between: both ends have the same integer part, or upper is the next integer. The ends turn
  // round under 1/x.
  const Rational low = lower - Rational(whole), high = *upper - Rational(whole);
  const Rational inner = simplest_positive(1 / high, low.is_zero() ? std::nullopt : std::optional<Rational>(1 / low));
  return Rational(whole) + 1 / inner;
}

}  // namespace

Integer height(const Rational& x) {
  const Integer n = abs(numerator(x)), d = denominator(x);
  return n > d ? n : d;
}

Rational simplest_between(const std::optional<Rational>& lower, const std::optional<Rational>& upper) {
  if (lower && upper && *lower >= *upper) throw std::invalid_argument("nothing lies between the ends");
  if ((!lower || *lower < 0) && (!upper || *upper > 0)) return 0;
  if (lower && *lower >= 0) return simplest_positive(*lower, upper);
  return -simplest_positive(-*upper, lower ? std::optional<Rational>(-*lower) : std::nullopt);
}

}  // namespace slipproof
