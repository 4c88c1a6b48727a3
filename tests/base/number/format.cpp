#include "base/number/format.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <random>
#include <stdexcept>
#include <string>

#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"

using slipproof::decimal_text;
using slipproof::exact_text;
using slipproof::Integer;
using slipproof::parse_rational;
using slipproof::Rational;

TEST_CASE("exact text is a fraction in lowest terms, or an integer") {
  CHECK(exact_text(Rational(6, 8)) == "3/4");
  CHECK(exact_text(Rational(-10, 2)) == "-5");
  CHECK(exact_text(0) == "0");
}

TEST_CASE("exact text reads back") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 5000; ++i) {
    const Integer p = Integer(random()) * Integer(random()) - Integer(random());
    const Rational x(i % 2 == 0 ? p : Integer(-p), Integer(random() >> (random() % 60)) + 1);
    CHECK(parse_rational(exact_text(x)) == x);
  }
}

TEST_CASE("decimals round the exact value, ties to even") {
  CHECK(decimal_text(Rational(2, 3), 3) == "0.667");
  CHECK(decimal_text(Rational(-2, 3), 1) == "-0.7");
  CHECK(decimal_text(Rational(1, 8), 2) == "0.12");
  CHECK(decimal_text(Rational(3, 8), 2) == "0.38");
  CHECK(decimal_text(parse_rational("0.125000000000000000000000000001"), 2) == "0.13");
  CHECK(decimal_text(parse_rational("99.95"), 3) == "100");
  CHECK(decimal_text(parse_rational("999.5"), 3) == "1e+03");
  CHECK(decimal_text(parse_rational("0.00099999"), 2) == "0.001");
  CHECK(decimal_text(100, 17) == "100");
  CHECK(decimal_text(0, 5) == "0");
  CHECK_THROWS_AS(decimal_text(1, 0), std::invalid_argument);
}

TEST_CASE("decimals far outside of binary64") {
  CHECK(decimal_text(parse_rational("-1.2345e5000"), 3) == "-1.23e+5000");
  CHECK(decimal_text(parse_rational("9.999e-5000"), 3) == "1e-4999");
  for (unsigned n = 1; n < 400; ++n) {
    const Rational power(pow(Integer(10), n));
    const std::string exponent = (n < 10 ? "0" : "") + std::to_string(n);
    CAPTURE(n);
    CHECK(decimal_text(power * 1000, 1) == "1e+" + (n + 3 < 10 ? "0" : std::string()) + std::to_string(n + 3));
    CHECK(decimal_text(power - Rational(1, 7), 1) == "1e+" + exponent);
    if (n > 4) CHECK(decimal_text(1 / power, 4) == "1e-" + exponent);
  }
}

TEST_CASE("a double's decimals are those of printf") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    double x = std::bit_cast<double>(random());
    if (i % 2 == 0)
      x = std::ldexp(static_cast<double>(random() >> (random() % 64)), static_cast<int>(random() % 40) - 30);
    if (!std::isfinite(x) || x == 0) continue;
    const int digits = 1 + static_cast<int>(random() % 25);
    char expected[80];
    std::snprintf(expected, sizeof expected, "%.*g", digits, x);
    CHECK(decimal_text(slipproof::to_rational(x), digits) == expected);
  }
}

TEST_CASE("seventeen digits identify a double") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 5000; ++i) {
    const double x = std::bit_cast<double>(random());
    if (!std::isfinite(x)) continue;
    const std::string text = decimal_text(slipproof::to_rational(x), 17);
    CHECK(slipproof::nearest_binary64(parse_rational(text)) == x);
  }
}
