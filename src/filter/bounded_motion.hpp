// The motion of a mode in floating point, every quantity with a bound on its error.
#pragma once

#include <cmath>
#include <limits>

#include "filter/bounds.hpp"
#include "model/reduction.hpp"

namespace slipproof {

/// |value - exact| <= error; an infinite error where nothing is known.
struct Bounded {
  double value = 0;
  double error = 0;
};

/// A quotient of numbers with value() and error().
template <class N>
Bounded bounded(const Quotient<N, N>& q) {
  constexpr double up = 1 + 8 * unit_roundoff;  // pays for the roundings of the bound itself
  const double n = q.numerator.value(), d = q.denominator.value();
  const double value_error = unit_roundoff;  // value() may be the rounded upper part of a longer number
  const double n_error = (q.numerator.error() + value_error * std::fabs(n)) * up;
  const double d_error = (q.denominator.error() + value_error * std::fabs(d)) * up;
  const double smallest = std::fabs(d) * (1 - 4 * unit_roundoff) - d_error;
  if (!(smallest > 0)) return {0, std::numeric_limits<double>::infinity()};
  const double value = n / d;
  const double error =
      ((n_error + std::fabs(value) * up * d_error) / smallest + unit_roundoff * std::fabs(value)) * up +
      std::numeric_limits<double>::min();
  return {value, error};
}

}  // namespace slipproof
