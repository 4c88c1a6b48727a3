// Between exact numbers, integers over a power of 2, and numbers of 106 bits.
#pragma once

#include <cstdlib>

#include "base/number/binary64.hpp"
#include "contact/linear/double_double.hpp"

namespace slipproof {

inline Rational power_of_two(int exponent) {
  Integer power = Integer(1) << static_cast<std::size_t>(std::abs(exponent));
  return exponent >= 0 ? Rational(std::move(power)) : Rational(Integer(1), power);
}

/// The integer part of x 2^digits.
inline Integer scaled_truncation(const Rational& x, int digits) {
  const Rational scaled = x * power_of_two(digits);
  return numerator(scaled) / denominator(scaled);
}

/// The nearest number of 106 bits, or one beside it.
inline DoubleDouble to_double_double(const Rational& x) {
  const double high = nearest_binary64(x);
  return DoubleDouble::fast_sum(high, nearest_binary64(x - to_rational(high)));
}

inline Rational exact_number(const DoubleDouble& x) {
  return to_rational(x.high) + to_rational(x.low);
}

}  // namespace slipproof
