// Between exact rationals and binary64 (double).
#pragma once

#include <span>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof {

/// The value of `x`, exactly; both zeros give 0. Throws NumberError for NaN and the infinities.
Rational to_rational(double x);
std::vector<Rational> to_rationals(std::span<const double> values);

/// The binary64 nearest to `x`, as IEEE 754 rounds the exact value: ties to even, subnormals included, to an infinity
/// from DBL_MAX + ulp/2 on. Zero gives +0; a negative x that underflows gives -0. Independent of the rounding mode.
double nearest_binary64(const Rational& x);

/// Doubles that enclose a number: lower <= x <= upper, the tightest such; equal exactly when x is a binary64.
/// Beyond DBL_MAX one of them is an infinity.
struct Binary64Bounds {
  double lower;
  double upper;
};
Binary64Bounds enclose(const Rational& x);

}  // namespace slipproof
