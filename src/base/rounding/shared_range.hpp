// Ranges over many points: bounds that contain all computed values, and a bound on the error of each;
// src/floating/tape/MATHEMATICS.md derives it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rounding/running_bounds.hpp"

namespace slipproof {

/// For each point whose inputs lie in the ranges of the inputs, RunningError computes a value from `lower` to `upper`
/// and an error bound of at most `error`, because it uses the same formulas, and these and rounding are monotone.
/// `lower` and `upper` may be replaced together, if the same is done at each point; `error` then refers to the values
/// before. If nothing is known, the error is infinite or NaN.
struct SharedRange {
  double lower = 0, upper = 0, error = 0;

  double size() const { return std::max(std::fabs(lower), std::fabs(upper)); }
  bool known() const { return error < std::numeric_limits<double>::infinity(); }
  bool positive() const { return known() && lower > error; }
  bool negative() const { return known() && upper < -error; }
  bool not_negative() const { return positive() || (known() && error == 0 && lower >= 0); }
  bool not_zero() const { return positive() || negative(); }
  bool zero() const { return known() && error == 0 && lower == 0 && upper == 0; }
};

inline SharedRange operator-(const SharedRange& x) {
  return {-x.upper, -x.lower, x.error};
}
inline SharedRange operator+(const SharedRange& x, const SharedRange& y) {
  SharedRange sum{x.lower + y.lower, x.upper + y.upper, 0};
  sum.error = (x.error + y.error + batch_rounding * sum.size()) * bound_inflation;
  return sum;
}
inline SharedRange operator-(const SharedRange& x, const SharedRange& y) {
  return x + -y;
}
inline SharedRange operator*(const SharedRange& x, const SharedRange& y) {
  const auto [lower, upper] = std::minmax({x.lower * y.lower, x.lower * y.upper, x.upper * y.lower, x.upper * y.upper});
  SharedRange product{lower, upper, 0};
  const double size_x = x.size(), size_y = y.size(), most_x = size_x + x.error, most_y = size_y + y.error;
  const double propagated = size_x * y.error + x.error * most_y;
  const double rounded = batch_rounding * product.size() + (most_x > 0 && most_y > 0 ? batch_underflow : 0);
  product.error = (propagated + rounded) * bound_inflation;
  return product;
}
inline SharedRange operator/(const SharedRange& x, const SharedRange& y) {
  const double least = std::min(std::fabs(y.lower), std::fabs(y.upper)) - y.error;
  const bool known = (y.lower > 0 || y.upper < 0) && least > 0 && y.size() < batch_largest_divisor;
  if (!known) return {0, 0, std::numeric_limits<double>::infinity()};
  const auto [lower, upper] = std::minmax({x.lower / y.lower, x.lower / y.upper, x.upper / y.lower, x.upper / y.upper});
  SharedRange quotient{lower, upper, 0};
  const double underflow = x.size() + x.error > 0 ? batch_underflow : 0;
  const double propagated = (x.error + quotient.size() * y.error + underflow) / least;
  quotient.error = (propagated + batch_rounding * quotient.size() + underflow) * bound_inflation;
  return quotient;
}

}  // namespace slipproof
