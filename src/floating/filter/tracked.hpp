// binary64 beside the magnitude that bounds its error: the number type of the first tier.
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <bit>
#include <cmath>

#include "base/number/rational.hpp"
#include "floating/filter/bounds.hpp"

namespace slipproof {

/// The value of an expression in +, -, * computed in binary64, and the same expression with all signs made positive:
/// |value - exact| <= roundings u magnitude + underflow (bounds.hpp), whatever cancels. Both are one pair of a vector
/// register, so that a tracked operation is one instruction, like a plain one.
class Tracked {
 public:
  Tracked() : pair_{0, 0} {}
  explicit Tracked(int constant) : pair_{double(constant), std::fabs(double(constant))} {}
  /// An input, exact or rounded once.
  static Tracked input(double x) { return Tracked(Pair{x, std::fabs(x)}); }

  double value() const { return pair_[0]; }
  double magnitude() const { return pair_[1]; }
  /// Bound on |value - exact|.
  double error() const { return magnitude() * (error_roundings * unit_roundoff) + underflow_error; }

  friend Tracked operator+(Tracked x, Tracked y) { return Tracked(x.pair_ + y.pair_); }
  friend Tracked operator*(Tracked x, Tracked y) { return Tracked(x.pair_ * y.pair_); }
  friend Tracked operator-(Tracked x) {
    const Pair flip{-0.0, 0.0};
    return Tracked(std::bit_cast<Pair>(std::bit_cast<Bits>(x.pair_) ^ std::bit_cast<Bits>(flip)));
  }
  friend Tracked operator-(Tracked x, Tracked y) {  // one instruction where there is SSE3
    return Tracked(__builtin_shufflevector(x.pair_ - y.pair_, x.pair_ + y.pair_, 0, 3));
  }
  /// As in mode_status.hpp, both comparisons at once: the sign bits of error - value and error + value. Not for NaN,
  /// which may have one.
  friend int certain_sign(Tracked x) {
    const Pair to_error{1, error_roundings * unit_roundoff}, underflow{0, underflow_error};
    const Pair value_error = x.pair_ * to_error + underflow;
    const Pair error_value = __builtin_shufflevector(value_error, value_error, 1, 0);
    const Pair sums = __builtin_shufflevector(error_value - value_error, error_value + value_error, 0, 3);
#ifdef __SSE2__
    return _mm_movemask_pd(sums);
#else
    return (sums[0] < 0 ? 1 : 0) | (sums[1] < 0 ? 2 : 0);
#endif
  }

 private:
  typedef double Pair __attribute__((vector_size(16)));
  typedef long long Bits __attribute__((vector_size(16)));
  explicit Tracked(Pair pair) : pair_(pair) {}
  Pair pair_;
};

/// What is certain of the sign of the exact value.
inline bool certainly_positive(Tracked x) {
  return x.value() > x.error();
}
inline bool certainly_negative(Tracked x) {
  return x.value() < -x.error();
}

}  // namespace slipproof
