// Fractions that nobody has brought to lowest terms yet: a greatest common divisor takes longer than all that is asked
// of most of them.
#pragma once

#include "base/number/rational.hpp"

namespace slipproof {

struct RawFraction {
  Integer numerator, denominator;

  /// -1, 0 or 1; the denominator must not be 0.
  int sign() const { return numerator.sign() * denominator.sign(); }
};

}  // namespace slipproof
