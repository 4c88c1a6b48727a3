#include "base/number/binary64.hpp"

#include <doctest/doctest.h>
#include <mpfr.h>

#include <bit>
#include <cfenv>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "base/number/parse.hpp"
#include "support/random_binary64.hpp"

using slipproof::enclose;
using slipproof::Integer;
using slipproof::nearest_binary64;
using slipproof::Rational;
using slipproof::to_rational;
using slipproof::test::random_finite;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool same_bits(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}

/// The judge: MPFR with binary64's precision, exponent range and subnormals.
double mpfr_rounded(const Rational& x, mpfr_rnd_t direction) {
  const mpfr_exp_t old_min = mpfr_get_emin();
  const mpfr_exp_t old_max = mpfr_get_emax();
  mpfr_set_emin(-1073);
  mpfr_set_emax(1024);
  mpfr_t y;
  mpfr_init2(y, 53);
  int ternary = mpfr_set_q(y, slipproof::GmpRational(x).get(), direction);
  ternary = mpfr_check_range(y, ternary, direction);
  mpfr_subnormalize(y, ternary, direction);
  const double result = mpfr_get_d(y, direction);
  mpfr_clear(y);
  mpfr_set_emin(old_min);
  mpfr_set_emax(old_max);
  return result;
}

void check_against_mpfr(const Rational& x) {
  CAPTURE(x.str());
  CHECK(nearest_binary64(x) == mpfr_rounded(x, MPFR_RNDN));
  CHECK(enclose(x).lower == mpfr_rounded(x, MPFR_RNDD));
  CHECK(enclose(x).upper == mpfr_rounded(x, MPFR_RNDU));
}

}  // namespace

TEST_CASE("a double is read exactly, and NaN and the infinities are refused") {
  CHECK(to_rational(0.5) == Rational(1, 2));
  CHECK(to_rational(-0.0) == 0);
  CHECK(to_rational(0.1) != Rational(1, 10));
  CHECK(to_rational(0.1) == Rational(Integer("3602879701896397"), Integer(1) << 55U));
  CHECK(to_rational(DBL_TRUE_MIN) == Rational(Integer(1), Integer(1) << 1074U));
  CHECK(to_rational(DBL_MAX) == Rational((Integer(1) << 1024U) - (Integer(1) << 971U)));
  CHECK_THROWS_WITH_AS(to_rational(std::nan("")), "found NaN, expected a finite number", slipproof::NumberError);
  CHECK_THROWS_WITH_AS(to_rational(-infinity), "found infinity, expected a finite number", slipproof::NumberError);
}

TEST_CASE("a double is its own nearest double and its own enclosure") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    double x = random_finite(random);
    if (i % 4 == 0) x = std::ldexp(x, -2000) + (i % 8 == 0 ? DBL_TRUE_MIN * static_cast<double>(i) : 0.0);
    if (x == 0) continue;
    const Rational exact = to_rational(x);
    CHECK(same_bits(nearest_binary64(exact), x));
    CHECK(same_bits(enclose(exact).lower, x));
    CHECK(same_bits(enclose(exact).upper, x));
  }
}

TEST_CASE("ties go to even, and anything off a tie to its own side") {
  std::mt19937_64 random(2);
  const Rational tiny = 1 / Rational(Integer(1) << 3000U);
  for (int i = 0; i < 2000; ++i) {
    double below = std::fabs(random_finite(random));
    if (i % 3 == 0) below = std::fabs(std::bit_cast<double>(random() >> 12U));  // subnormal
    const double above = std::nextafter(below, infinity);
    if (std::isinf(above)) continue;
    const Rational middle = (to_rational(below) + to_rational(above)) / 2;
    const double even = (std::bit_cast<std::uint64_t>(below) & 1U) == 0 ? below : above;
    CHECK(nearest_binary64(middle) == even);
    CHECK(nearest_binary64(-middle) == -even);
    CHECK(nearest_binary64(middle - tiny) == below);
    CHECK(nearest_binary64(middle + tiny) == above);
    CHECK(enclose(middle).lower == below);
    CHECK(enclose(middle).upper == above);
    CHECK(enclose(-middle).lower == -above);
    CHECK(enclose(-middle).upper == -below);
    CHECK(enclose(to_rational(below) + tiny).lower == below);
    CHECK(enclose(to_rational(below) + tiny).upper == above);
  }
}

TEST_CASE("overflow begins at DBL_MAX + ulp/2") {
  const Rational half_ulp(Integer(1) << 970U);
  const Rational limit = to_rational(DBL_MAX) + half_ulp;
  CHECK(nearest_binary64(limit - Rational(1, 3)) == DBL_MAX);
  CHECK(nearest_binary64(limit) == infinity);
  CHECK(nearest_binary64(-limit) == -infinity);
  CHECK(nearest_binary64(slipproof::parse_rational("1e5000")) == infinity);
  CHECK(enclose(to_rational(DBL_MAX) + 1).lower == DBL_MAX);
  CHECK(enclose(to_rational(DBL_MAX) + 1).upper == infinity);
  CHECK(enclose(slipproof::parse_rational("-1e5000")).lower == -infinity);
  CHECK(enclose(slipproof::parse_rational("-1e5000")).upper == -DBL_MAX);
}

TEST_CASE("underflow keeps the sign, and zero is +0") {
  const Rational half = to_rational(DBL_TRUE_MIN) / 2;
  CHECK(same_bits(nearest_binary64(0), 0.0));
  CHECK(same_bits(nearest_binary64(half), 0.0));
  CHECK(same_bits(nearest_binary64(-half), -0.0));
  CHECK(nearest_binary64(half * Rational(1001, 1000)) == DBL_TRUE_MIN);
  CHECK(same_bits(nearest_binary64(slipproof::parse_rational("-1e-5000")), -0.0));
  CHECK(same_bits(enclose(0).lower, 0.0));
  CHECK(same_bits(enclose(0).upper, 0.0));
  CHECK(enclose(slipproof::parse_rational("1e-5000")).lower == 0.0);
  CHECK(enclose(slipproof::parse_rational("1e-5000")).upper == DBL_TRUE_MIN);
  CHECK(enclose(slipproof::parse_rational("-1e-5000")).lower == -DBL_TRUE_MIN);
}

TEST_CASE("every rounding is MPFR's") {
  std::mt19937_64 random(3);
  const auto integer = [&random](unsigned bits) {
    Integer n = 0;
    for (unsigned i = 0; i < bits; i += 32) n = (n << 32U) + static_cast<unsigned>(random());
    return Integer(n >> ((32 - bits % 32) % 32));
  };
  for (int i = 0; i < 20000; ++i) {
    const Rational p(integer(static_cast<unsigned>(random() % 150)) + 1);
    const Rational q(integer(static_cast<unsigned>(random() % 150)) + 1);
    const Rational x = (random() & 1U) != 0 ? Rational(p / q) : Rational(-p / q);
    check_against_mpfr(x);
    const Rational power(Integer(1) << (900 + random() % 260));
    check_against_mpfr(x * power);
    check_against_mpfr(x / power);
  }
}

TEST_CASE("nearest agrees with strtod on decimals, the hard ones included") {
  const char* hard[] = {"2.2250738585072011e-308",
                        "2.2250738585072012e-308",
                        "2.2250738585072014e-308",
                        "4.9406564584124654e-324",
                        "2.4703282292062327e-324",
                        "2.4703282292062328e-324",
                        "1.7976931348623157e308",
                        "1.7976931348623158e308",
                        "1.7976931348623159e308",
                        "9007199254740993",
                        "9007199254740993.00000000000000000000000000000001",
                        "1e23",
                        "8.5e22",
                        "6.02214076e23",
                        "7.2057594037927933e16",
                        "0.1",
                        "0.3"};
  for (const char* text : hard) {
    CAPTURE(text);
    CHECK(nearest_binary64(slipproof::parse_rational(text)) == std::strtod(text, nullptr));
  }
  std::mt19937_64 random(4);
  for (int i = 0; i < 5000; ++i) {
    const std::string text = std::to_string(random()) + "e" + std::to_string(static_cast<int>(random() % 680) - 350);
    CAPTURE(text);
    CHECK(nearest_binary64(slipproof::parse_rational(text)) == std::strtod(text.c_str(), nullptr));
  }
}

TEST_CASE("the rounding mode of the machine does not matter") {
  const Rational third(1, 3);
  const double nearest = nearest_binary64(third);
  const auto bounds = enclose(third);
  for (int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const double again = nearest_binary64(third);
    const auto bounds_again = enclose(third);
    std::fesetround(FE_TONEAREST);
    CHECK(again == nearest);
    CHECK(bounds_again.lower == bounds.lower);
    CHECK(bounds_again.upper == bounds.upper);
  }
}
