// Where the error bounds of the filter come from: a number type that counts, run through the same template.
#pragma once

#include <algorithm>

#include "base/number/rational.hpp"

namespace slipproof::test {

/// What is known of the floating-point error of an expression, before any value is known. With |input| <= input_limit,
///   |computed - exact| <= gamma(roundings) magnitude + underflow 2^-1075,
/// where magnitude bounds the expression with all signs made positive.
struct ErrorCount {
  long roundings = 0;
  Integer magnitude = 0;
  Integer underflow = 0;
  bool unit = false;  ///< +1 or -1: multiplying by it is exact

  ErrorCount() = default;
  explicit ErrorCount(int constant) : magnitude(std::abs(constant)), unit(std::abs(constant) == 1) {}
  /// A binary64 nearest to a real: one rounding, or half of the smallest subnormal.
  static ErrorCount input(const Integer& limit) {
    ErrorCount x;
    x.roundings = 1;
    x.magnitude = limit;
    x.underflow = 1;
    return x;
  }

  friend ErrorCount operator*(const ErrorCount& x, const ErrorCount& y) {
    if (x.unit || x.magnitude == 0) return x.magnitude == 0 ? x : y;
    if (y.unit || y.magnitude == 0) return y.magnitude == 0 ? y : x;
    ErrorCount r;
    r.roundings = x.roundings + y.roundings + 1;
    r.magnitude = x.magnitude * y.magnitude;
    // Both errors meet in a product of underflows, (x 2^-1075)(y 2^-1075): far below one unit while x, y < 2^1000.
    r.underflow = x.underflow * y.magnitude + y.underflow * x.magnitude + 2;
    return r;
  }
  friend ErrorCount operator+(const ErrorCount& x, const ErrorCount& y) {
    if (x.magnitude == 0) return y;
    if (y.magnitude == 0) return x;
    ErrorCount r;  // a sum of binary64 never underflows
    r.roundings = std::max(x.roundings, y.roundings) + 1;
    r.magnitude = x.magnitude + y.magnitude;
    r.underflow = x.underflow + y.underflow;
    return r;
  }
  friend ErrorCount operator-(const ErrorCount& x) { return x; }
  friend ErrorCount operator-(const ErrorCount& x, const ErrorCount& y) { return x + y; }
};

/// log2 rounded up.
inline long bits(const Integer& x) {
  return static_cast<long>(x.bits());
}

}  // namespace slipproof::test
