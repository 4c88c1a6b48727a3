// The motion of a mode in floating point, every quantity with a bound on its error.
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include "floating/filter/bounds.hpp"
#include "floating/filter/lane_vectors.hpp"
#include "mechanics/bicycle/reduction.hpp"

namespace slipproof {

/// |value - exact| <= error; an infinite error where nothing is known.
struct Bounded {
  double value = 0;
  double error = 0;
};

/// Of a number with bounds; lanes.hpp has it for several side by side.
template <class N>
double value_of(const N& x) {
  return x.value();
}

/// A quotient of numbers with value_of() and error(), each a Real: binary64 or several of them.
template <class Real, class N>
std::pair<Real, Real> bounded_parts(const Quotient<N, N>& q) {
  constexpr double up = 1 + 8 * unit_roundoff;  // pays for the roundings of the bound itself
  const Real n = value_of(q.numerator), d = value_of(q.denominator);
  const double value_error = unit_roundoff;  // value() may be the rounded upper part of a longer number
  const Real n_error = (q.numerator.error() + value_error * absolute(n)) * up;
  const Real d_error = (q.denominator.error() + value_error * absolute(d)) * up;
  const Real smallest = absolute(d) * (1 - 4 * unit_roundoff) - d_error;
  const auto known = smallest > 0;
  const Real value = known ? n / d : Real{};
  const Real error = ((n_error + absolute(value) * up * d_error) / smallest + unit_roundoff * absolute(value)) * up +
                     std::numeric_limits<double>::min();
  return {value, known ? error : Real{} + std::numeric_limits<double>::infinity()};
}

template <class N>
Bounded bounded(const Quotient<N, N>& q) {
  const auto [value, error] = bounded_parts<double>(q);
  return {value, error};
}

}  // namespace slipproof
