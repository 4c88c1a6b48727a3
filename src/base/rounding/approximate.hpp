// binary64 beside a bound on its error: the filter before exact arithmetic, where most signs are far from 0.
//
// |value - exact| <= error, for every operation. With u = 2^-53 and rounding to nearest:
//
//   x + y   e_x + e_y + r, where r is what the sum lost to rounding: TwoSum (Knuth) gives it exactly
//   x y     |x| e_y + e_x (|y| + e_y) + u |value| + underflow
//   x / y   (e_x + |value| e_y + underflow) / (|y| - e_y) + u |value| + underflow; infinite unless |y| - e_y > 0
//
// src/floating/tape/MATHEMATICS.md derives the last two, and why the constants pay for the roundings and the underflow
// of the bounds themselves. An overflow makes value or error infinite or NaN, and every question below is a comparison
// that is false then. No rounding mode is set, and -ffp-contract=off keeps TwoSum what it is.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "base/number/rational.hpp"
#include "base/rounding/running_bounds.hpp"

namespace slipproof {

struct Approximate {
  double value = 0, error = 0;

  Approximate() = default;
  Approximate(double exact) : value(exact) {}  // NOLINT: a binary64 is itself
  Approximate(double nearby, double bound) : value(nearby), error(bound) {}
  explicit Approximate(const Rational& x);

  bool is_zero() const { return value == 0 && error == 0; }  ///< surely
};

/// Bound on the loss of a product or quotient by underflow; 0 for an exact 0.
inline double underflow_unless_zero(double size_of_x, double size_of_y) {
  return size_of_x > 0 && size_of_y > 0 ? batch_underflow : 0;
}

inline Approximate operator-(const Approximate& x) {
  return {-x.value, x.error};
}
inline Approximate operator+(const Approximate& x, const Approximate& y) {
  const double value = x.value + y.value, of_y = value - x.value;
  const double rounded = (x.value - (value - of_y)) + (y.value - of_y);
  return {value, (x.error + y.error + std::fabs(rounded)) * bound_inflation};
}
inline Approximate operator-(const Approximate& x, const Approximate& y) {
  return x + -y;
}
inline Approximate operator*(const Approximate& x, const Approximate& y) {
  const double value = x.value * y.value, size_x = std::fabs(x.value), most_y = std::fabs(y.value) + y.error;
  const double propagated = size_x * y.error + x.error * most_y;
  const double rounded = batch_rounding * std::fabs(value) + underflow_unless_zero(size_x + x.error, most_y);
  return {value, (propagated + rounded) * bound_inflation};
}
inline Approximate operator/(const Approximate& x, const Approximate& y) {
  const double value = x.value / y.value, size = std::fabs(value), size_y = std::fabs(y.value);
  const double least = size_y - y.error, underflow = underflow_unless_zero(std::fabs(x.value) + x.error, 1);
  if (!(least > 0 && size_y < batch_largest_divisor)) return {value, std::numeric_limits<double>::infinity()};
  const double propagated = (x.error + size * y.error + underflow) / least;
  return {value, (propagated + batch_rounding * size + underflow) * bound_inflation};
}

/// The sign, -1, 0 or +1; nothing if the error bound leaves it undecided.
inline std::optional<int> sure_sign(const Approximate& x) {
  if (x.value > x.error) return 1;
  if (x.value < -x.error) return -1;
  if (x.is_zero()) return 0;
  return std::nullopt;
}

}  // namespace slipproof
