// Sums of products of binary64 numbers, without rounding.
#pragma once

#include <array>
#include <cstdint>

#include "base/number/rational.hpp"

namespace slipproof {

/// A fixed-point number wide enough for every product of two doubles, in digits of 32 bits that carry only at the end:
/// adding costs a few integer operations, where rationals would allocate. (Kulisch's long accumulator.) Up to 2^30
/// terms; not for NaN and infinities.
class ExactSum {
 public:
  void add(double a) { add(a, 1); }
  /// Adds a b.
  void add(double a, double b);
  /// The sum so far, exactly.
  Rational value() const;
  /// The binary64 nearest to it, ties to even; nothing is allocated, unless it is subnormal or near overflow.
  double nearest() const;

 private:
  static constexpr int lowest = -2 * 1074;  ///< exponent of the last bit of the smallest product
  static constexpr std::size_t digits = 136;
  std::array<std::int64_t, digits> digit_{};
  std::size_t first_ = digits, last_ = 0;  ///< those that were touched: [first_, last_)
};

}  // namespace slipproof
