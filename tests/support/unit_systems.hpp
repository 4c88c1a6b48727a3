// The same quantities in other units.
#pragma once

#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "base/number/rational.hpp"
#include "mechanics/mechanism/units.hpp"

namespace slipproof::test {

/// How many of its own units of length, mass and time make up a metre, a kilogram and a second.
struct UnitSystem {
  const char* name;
  Rational length, mass, time;

  /// The factor of a quantity in `unit`, which is made of m, kg and s.
  Rational factor(const std::string& unit) const {
    const std::string text = parse_unit(unit).value().text();  // as in m.kg.s-2
    Rational result = 1;
    for (std::size_t at = 0; at < text.size();) {
      std::size_t end = text.find('.', at);
      if (end == std::string::npos) end = text.size();
      const std::string part = text.substr(at, end - at);
      const std::size_t digits = part.find_first_of("-0123456789");
      const std::string symbol = part.substr(0, digits);
      const int exponent = digits == std::string::npos ? 1 : std::stoi(part.substr(digits));
      if (symbol == "m") result *= power(length, exponent);
      if (symbol == "kg") result *= power(mass, exponent);
      if (symbol == "s") result *= power(time, exponent);
      at = end + 1;
    }
    return result;
  }

 private:
  static Rational power(const Rational& x, int exponent) {
    Rational result = 1;
    for (int i = 0; i < (exponent < 0 ? -exponent : exponent); ++i) result *= x;
    return exponent < 0 ? Rational(1 / result) : result;
  }
};

/// SI first; the last is exact in binary64.
inline const std::vector<UnitSystem>& unit_systems() {
  static const std::vector<UnitSystem> all{
      {"m kg s", 1, 1, 1},
      {"mm g s", 1000, 1000, 1},
      {"ft lb min", Rational(1250, 381), Rational("100000000/45359237"), Rational(1, 60)},
      {"powers of two", 1024, Rational(1, 128), 32}};
  return all;
}

}  // namespace slipproof::test
