// Random numbers that parameters are given: small ones, which people can check.
#pragma once

#include <cstdint>

#include "base/number/dice.hpp"
#include "base/number/rational.hpp"
#include "base/rounding/approximate.hpp"

namespace slipproof {

enum class NumberKind : std::uint8_t {
  ones,       ///< 1 half of the time
  integers,   ///< up to 6
  fractions,  ///< up to 12, over up to 8
  wide,       ///< a fraction, half of the time times a power of two from 2^-20 to 2^20
  extreme     ///< the same from 2^-40 to 2^40
};

/// numerator / denominator * 2^exponent; one in ten is 0, one in four negative.
struct DrawnNumber {
  int numerator = 0, denominator = 1, exponent = 0;

  Rational value() const;
};

DrawnNumber draw_number(Dice& dice, NumberKind kind);

/// False if no number of this kind can be equal to x, other than 0.
bool may_be_drawn(const Approximate& x, NumberKind kind);

}  // namespace slipproof
