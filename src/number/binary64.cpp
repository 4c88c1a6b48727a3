#include "number/binary64.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "number/parse.hpp"

namespace slipproof {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);

namespace {

constexpr long digits = 53;
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

long bit_length(mpz_srcptr x) {
  return static_cast<long>(mpz_sizeinbase(x, 2));
}

Truncated truncate(const Rational& x) {
  mpq_srcptr value = x.backend().data();
  mpz_srcptr numerator = mpq_numref(value);
  mpz_srcptr denominator = mpq_denref(value);
  // 2^(k-1) < |x| < 2^(k+1): the quotient below has 53 or 54 bits, or fewer for subnormals.
  const long k = bit_length(numerator) - bit_length(denominator);
  long exponent = std::max(k - digits, lowest_exponent);
  Integer dividend;
  Integer divisor;
  mpz_abs(dividend.backend().data(), numerator);
  divisor.backend() = denominator;
  if (exponent < 0) {
    dividend <<= static_cast<unsigned long>(-exponent);
  } else {
    divisor <<= static_cast<unsigned long>(exponent);
  }
  Integer quotient;
  Integer remainder;
  divide_qr(dividend, divisor, quotient, remainder);
  if (bit_length(quotient.backend().data()) > digits) {
    if (bit_test(quotient, 0)) remainder += divisor;
    quotient >>= 1;
    divisor <<= 1;
    ++exponent;
  }
  const int remainder_vs_half = Integer(remainder << 1).compare(divisor);
  return {quotient, exponent, (remainder_vs_half > 0) - (remainder_vs_half < 0), remainder.is_zero()};
}

/// (quotient + up) * 2^exponent; exact up to overflow to infinity.
double assemble(const Truncated& truncated, bool up) {
  if (truncated.exponent > highest_exponent) return std::numeric_limits<double>::infinity();
  const double significand = static_cast<double>(mpz_get_ui(truncated.quotient.backend().data()) + (up ? 1UL : 0UL));
  return std::ldexp(significand, static_cast<int>(truncated.exponent));
}

}  // namespace

Rational to_rational(double x) {
  if (std::isnan(x)) throw NumberError(0, "NaN", "a finite number");
  if (std::isinf(x)) throw NumberError(0, "infinity", "a finite number");
  Rational result;
  mpq_set_d(result.backend().data(), x);
  return result;
}

double nearest_binary64(const Rational& x) {
  if (x.is_zero()) return 0.0;
  const Truncated truncated = truncate(x);
  const bool odd = bit_test(truncated.quotient, 0);
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
