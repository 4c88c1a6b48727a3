// Fractions that need not be in lowest terms: computing a greatest common divisor costs more than most of them are used
// for.
#pragma once

#include "base/number/rational.hpp"

namespace slipproof {

struct RawFraction {
  Integer numerator, denominator;

  /// The sign: -1, 0 or +1. The denominator must not be 0.
  int sign() const { return numerator.sign() * denominator.sign(); }
};

}  // namespace slipproof
