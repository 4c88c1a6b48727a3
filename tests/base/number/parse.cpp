#include "base/number/parse.hpp"

#include <doctest/doctest.h>

#include <charconv>
#include <cstdint>
#include <random>
#include <string>

#include "base/number/binary64.hpp"
#include "support/random_binary64.hpp"

using slipproof::Integer;
using slipproof::NumberError;
using slipproof::parse_rational;
using slipproof::Rational;
using slipproof::test::random_finite;

namespace {

Rational power_of_ten(unsigned n) {
  return Rational(pow(Integer(10), n));
}

}  // namespace

TEST_CASE("every form of a number is read exactly") {
  const std::pair<const char*, Rational> cases[] = {
      {"0", 0},
      {"-0", 0},
      {"+7", 7},
      {"-12", -12},
      {"007", 7},
      {"010", 10},  // not octal
      {"3/4", Rational(3, 4)},
      {"-6/8", Rational(-3, 4)},
      {"+0/5", 0},
      {"007/010", Rational(7, 10)},
      {"0.1", Rational(1, 10)},
      {".5", Rational(1, 2)},
      {"5.", 5},
      {"-.25", Rational(-1, 4)},
      {"1e-3", Rational(1, 1000)},
      {"2.5E+7", 25000000},
      {"1.20e1", 12},
      {"0e5000", 0},
      {"000.000", 0},
      {"0x1.8p-3", Rational(3, 16)},
      {"0X1.8P+3", 12},
      {"-0xff", -255},
      {"0x.8", Rational(1, 2)},
      {"0x010", 16},
      {"0x0p0", 0},
      {"0x1e3", 0x1e3},  // e is a digit there
  };
  for (const auto& [written, value] : cases) {
    const std::string text = written;  // clang 14 captures no structured binding
    CAPTURE(text);
    CHECK(parse_rational(text) == value);
  }
}

TEST_CASE("what is read is in lowest terms with a positive denominator") {
  const Rational x = parse_rational("-1.50");
  CHECK(numerator(x) == -3);
  CHECK(denominator(x) == 2);
}

TEST_CASE("every mistake in a number has its own message and its place") {
  struct Mistake {
    std::string text;
    std::size_t position;
    const char* message;
  };
  const Mistake mistakes[] = {
      {"", 0, "found nothing, expected a number"},
      {"-", 1, "found the end of the text, expected a digit"},
      {"+", 1, "found the end of the text, expected a digit"},
      {"--5", 1, "found '-', expected a digit"},
      {".", 1, "found the end of the text, expected a digit"},
      {"abc", 0, "found 'a', expected a digit"},
      {"12abc", 2, "found 'a', expected the end of the number"},
      {"1.2.3", 3, "found '.', expected the end of the number"},
      {"5%", 1, "found '%', expected the end of the number"},
      {"1_000", 1, "found '_', expected digits without separators"},
      {"1,5", 1, "found ',', expected '.' as the decimal point, and no separators"},
      {" 5", 0, "found a space, expected a number without spaces"},
      {"5 ", 1, "found a space, expected a number without spaces"},
      {"1 2", 1, "found a space, expected a number without spaces"},
      {"3 / 4", 1, "found a space, expected a number without spaces"},
      {"3/ 4", 2, "found a space, expected a number without spaces"},
      {"5\n", 1, "found a space, expected a number without spaces"},
      {"nan", 0, "found NaN, expected a finite number"},
      {"-NaN", 1, "found NaN, expected a finite number"},
      {"nan(0x1)", 0, "found NaN, expected a finite number"},
      {"inf", 0, "found infinity, expected a finite number"},
      {"-Infinity", 1, "found infinity, expected a finite number"},
      {"info", 0, "found 'i', expected a digit"},
      {"1/0", 2, "found a zero denominator, expected a denominator other than 0"},
      {"0/000", 2, "found a zero denominator, expected a denominator other than 0"},
      {"1/", 2, "found the end of the text, expected a digit"},
      {"/4", 0, "found '/', expected a digit"},
      {"3/-4", 2, "found a sign in the denominator, expected the sign in front of the fraction"},
      {"1/2/3", 3, "found '/', expected the end of the number"},
      {"0.5/3", 3,
       "found a '/' after a number that is not a decimal integer, expected a fraction of two integers, such as 3/4"},
      {"1e2/3", 3,
       "found a '/' after a number that is not a decimal integer, expected a fraction of two integers, such as 3/4"},
      {"0x1/3", 3,
       "found a '/' after a number that is not a decimal integer, expected a fraction of two integers, such as 3/4"},
      {"1/2.5", 2, "found a denominator that is not an integer, expected a fraction of two integers, such as 3/4"},
      {"1/2e3", 2, "found a denominator that is not an integer, expected a fraction of two integers, such as 3/4"},
      {"1/0x2", 2, "found a denominator that is not an integer, expected a fraction of two integers, such as 3/4"},
      {"1e", 2, "found the end of the text, expected a digit of the exponent"},
      {"1e+", 3, "found the end of the text, expected a digit of the exponent"},
      {"1e1.5", 3, "found '.', expected the end of the number"},
      {"0x", 2, "found the end of the text, expected a hexadecimal digit"},
      {"0xg", 2, "found 'g', expected a hexadecimal digit"},
      {"0x1p", 4, "found the end of the text, expected a digit of the exponent"},
      {"0x1.8q3", 5, "found 'q', expected the end of the hexadecimal number"},
      {"0b101", 1, "found 'b', expected the end of the number"},
      {"1e5001", 2, "found the exponent 5001, expected one from -5000 to 5000"},
      {"1e-5001", 2, "found the exponent -5001, expected one from -5000 to 5000"},
      {"1e999999999", 2, "found the exponent 999999999, expected one from -5000 to 5000"},
      {"1e99999999999999999999999999", 2,
       "found the exponent 99999999999999999999..., expected one from -5000 to 5000"},
      {"0e5001", 2, "found the exponent 5001, expected one from -5000 to 5000"},
      {"0x1p20001", 4, "found the exponent 20001, expected one from -20000 to 20000"},
      {std::string(10'001, '1'), 0, "found 10001 characters, expected at most 10000 in a number"},
      {"\xe2\x88\x92"
       "5",
       0, "found '\xe2\x88\x92', expected a digit"},  // U+2212, a minus sign that is not ASCII's
      {std::string("1\0", 2), 1, "found the byte 0x00, expected the end of the number"},
      {"1\xff", 1, "found the byte 0xff, expected the end of the number"},
      {"1\xe2", 1, "found the byte 0xe2, expected the end of the number"},
  };
  for (const auto& mistake : mistakes) {
    CAPTURE(mistake.text);
    try {
      const Rational x = parse_rational(mistake.text);
      FAIL_CHECK("was read as " << x.str());
    } catch (const NumberError& error) {
      CHECK(std::string(error.what()) == mistake.message);
      CHECK(error.position() == mistake.position);
    }
  }
}

TEST_CASE("the limits themselves are still read, and huge exponents cost nothing") {
  CHECK(parse_rational("1e5000") == power_of_ten(5000));
  CHECK(parse_rational("1e-5000") == 1 / power_of_ten(5000));
  CHECK(parse_rational("0x1p20000") == Rational(Integer(1) << 20000U));
  CHECK(parse_rational(std::string(10'000, '9')) == power_of_ten(10'000) - 1);
  CHECK(parse_rational("." + std::string(9'999, '9')) == 1 - 1 / power_of_ten(9'999));
  // The ends of binary128.
  CHECK(parse_rational("0x1p-16494") == 1 / Rational(Integer(1) << 16494U));
  CHECK_NOTHROW(parse_rational("6.47517511943802511092443895822764655e-4966"));
  CHECK_NOTHROW(parse_rational("1.18973149535723176508575932662800702e4932"));
}

TEST_CASE("a decimal is its digits over a power of ten, whatever it is") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t digits = random() >> (random() % 64);
    const auto places = static_cast<unsigned>(random() % 30);
    const int exponent = static_cast<int>(random() % 61) - 30;
    std::string text = std::to_string(digits);
    if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
    text.insert(text.size() - places, ".");
    text += "e" + std::to_string(exponent);
    Rational expected = Rational(Integer(digits)) / power_of_ten(places);
    expected = exponent < 0 ? Rational(expected / power_of_ten(static_cast<unsigned>(-exponent)))
                            : Rational(expected * power_of_ten(static_cast<unsigned>(exponent)));
    CAPTURE(text);
    CHECK(parse_rational(text) == expected);
  }
}

TEST_CASE("what the standard library prints of a double reads back") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 5000; ++i) {
    const double x = random_finite(random);
    char text[64];
    auto end = std::to_chars(text, text + sizeof text, x).ptr;
    CHECK(slipproof::nearest_binary64(parse_rational({text, end})) == x);
    std::snprintf(text, sizeof text, "%a", x);
    CAPTURE(text);
    CHECK(parse_rational(text) == slipproof::to_rational(x));
  }
}

TEST_CASE("the exact decimal expansion of a double reads as the double") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    const double x = random_finite(random);
    char text[1200];
    std::snprintf(text, sizeof text, "%.1074f", x);
    CHECK(parse_rational(text) == slipproof::to_rational(x));
  }
}
