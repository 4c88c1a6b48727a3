#include "base/number/binary64.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/number/flint_memory.hpp"
#include "base/number/parse.hpp"

namespace slipproof {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);

namespace {

constexpr int digits = 53;
constexpr long lowest_exponent = -1074;  // of the last place of subnormals
constexpr long highest_exponent = 971;   // of the last place of DBL_MAX

/// |x| = (quotient + remainder) * 2^exponent with 0 <= remainder < 1, quotient < 2^53 and no higher exponent possible
/// without loss; quotient * 2^exponent is a binary64, or overflows.
struct Truncated {
  Integer quotient;
  long exponent;
  int remainder_vs_half;  // sign of remainder - 1/2
  bool exact;             // remainder == 0
};

long bit_length(const Integer& x) {
  return static_cast<long>(x.bits());
}

Truncated truncate(const Rational& x) {
  // 2^(k-1) < |x| < 2^(k+1): the quotient below has 53 or 54 bits, or fewer for subnormals.
  const long k = bit_length(numerator(x)) - bit_length(denominator(x));
  long exponent = std::max(k - digits, lowest_exponent);
  Integer dividend = abs(numerator(x));
  Integer divisor = denominator(x);
  if (exponent < 0) {
    dividend <<= static_cast<unsigned long>(-exponent);
  } else {
    divisor <<= static_cast<unsigned long>(exponent);
  }
  auto [quotient, remainder] = divide(dividend, divisor);
  if (bit_length(quotient) > digits) {
    if (quotient.is_odd()) remainder += divisor;
    quotient >>= 1;
    divisor <<= 1;
    ++exponent;
  }
  const int remainder_vs_half = (remainder << 1).compare(divisor);
  return {std::move(quotient), exponent, remainder_vs_half, remainder.is_zero()};
}

/// (quotient + up) * 2^exponent; exact up to overflow to infinity.
double assemble(const Truncated& truncated, bool up) {
  if (truncated.exponent > highest_exponent) return std::numeric_limits<double>::infinity();
  const double significand = truncated.quotient.to_double() + (up ? 1 : 0);
  return std::ldexp(significand, static_cast<int>(truncated.exponent));
}

}  // namespace

Rational to_rational(double x) {
  if (std::isnan(x)) throw NumberError(0, "NaN", "a finite number");
  if (std::isinf(x)) throw NumberError(0, "infinity", "a finite number");
  give_back_flint_memory_at_end();
  int exponent = 0;
  const Integer significand = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), digits));
  return times_power_of_two(significand, exponent - digits);
}

std::vector<Rational> to_rationals(std::span<const double> values) {
  std::vector<Rational> result;
  result.reserve(values.size());
  for (const double x : values) result.push_back(to_rational(x));
  return result;
}

double nearest_binary64(const Rational& x) {
  if (x.is_zero()) return 0.0;
  const Truncated truncated = truncate(x);
  const bool odd = truncated.quotient.is_odd();
  const bool up = truncated.remainder_vs_half > 0 || (truncated.remainder_vs_half == 0 && odd);
  return std::copysign(assemble(truncated, up), sign(x));
}

Binary64Bounds enclose(const Rational& x) {
  if (x.is_zero()) return {0.0, 0.0};
  const Truncated truncated = truncate(x);
  const double inner = std::min(assemble(truncated, false), std::numeric_limits<double>::max());
  const double outer = assemble(truncated, !truncated.exact);
  return sign(x) > 0 ? Binary64Bounds{inner, outer} : Binary64Bounds{-outer, -inner};
}

}  // namespace slipproof
