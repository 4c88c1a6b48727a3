// Bounds on what rounding to nearest can do to sums, in any order, with fused products or without.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

namespace slipproof {

/// u = 2^-53: a rounding changes a result by at most this much of it, underflow apart.
inline constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// Above gamma_(2n + 16) = k u / (1 - k u): a sum of n products is within gamma |a| . |b| of the exact one; the bound
/// includes n more roundings.
constexpr double gamma_of(std::size_t n) {
  const double k = 2 * static_cast<double>(n) + 16;
  return k * unit_roundoff / (1 - k * unit_roundoff) * (1 + 4 * unit_roundoff);
}

/// Above the exact value, where x is the result of at most 2n + 8 roundings of nonnegative numbers that do not
/// underflow.
constexpr double rounded_up(double x, std::size_t n) {
  return x * (1 + gamma_of(n));
}

/// The exponent of the power of 2 that scales a size to about 1; 0 for 0, NaN and infinities.
inline int exponent_to_one(double size) {
  return size > 0 && std::isfinite(size) ? -std::ilogb(size) : 0;
}

/// Above what underflow can add to a sum of n products, with room for as many again.
constexpr double underflow_of(std::size_t n) {
  return static_cast<double>(n + 8) * 0x1p-1070;
}

}  // namespace slipproof
