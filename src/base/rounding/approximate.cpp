#include "base/rounding/approximate.hpp"

#include <cstdint>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

/// Beyond it the conversion of an integer to binary64 rounds.
constexpr std::int64_t exact_integers = std::int64_t{1} << 53;

/// Of shorter integers no quotient overflows or underflows.
constexpr std::size_t longest_quotient = 1000;

bool is_exact(std::int64_t x) {
  return -exact_integers <= x && x <= exact_integers;
}

}  // namespace

Approximate::Approximate(const Rational& x) {
  const Integer &n = numerator(x), &d = denominator(x);
  if (n.fits_long() && d.fits_long()) {
    const long dividend = n.to_long(), divisor = d.to_long();
    value = static_cast<double>(dividend) / static_cast<double>(divisor);
    if (!is_exact(dividend) || !is_exact(divisor)) {
      error = 2 * batch_rounding * std::fabs(value);  // three roundings, far from underflow
    } else if ((divisor & (divisor - 1)) != 0) {
      error = batch_rounding * std::fabs(value);
    }
  } else if (n.bits() < longest_quotient && d.bits() < longest_quotient) {
    value = n.to_double() / d.to_double();
    error = 4 * batch_rounding * std::fabs(value);  // both are cut off, by 2u, and the quotient is rounded
  } else {
    value = nearest_binary64(x);
    error = batch_rounding * std::fabs(value) + batch_underflow;
  }
}

}  // namespace slipproof
