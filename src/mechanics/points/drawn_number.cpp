#include "mechanics/points/drawn_number.hpp"

#include <cmath>
#include <vector>

namespace slipproof {

namespace {

constexpr int largest_numerator = 12, largest_denominator = 8;

/// Fractions in lowest terms, computed once: a sample may take thousands of them.
const Rational& small_fraction(int numerator, int denominator) {
  static const std::vector<Rational> all = [] {
    std::vector<Rational> fractions;
    for (int n = -largest_numerator; n <= largest_numerator; ++n) {
      for (int d = 1; d <= largest_denominator; ++d) fractions.emplace_back(n, d);
    }
    return fractions;
  }();
  return all[static_cast<std::size_t>((numerator + largest_numerator) * largest_denominator + denominator - 1)];
}

}  // namespace

Rational DrawnNumber::value() const {
  const Rational& small = small_fraction(numerator, denominator);
  return exponent == 0 ? small : small * power_of_two(exponent);
}

DrawnNumber draw_number(Dice& dice, NumberKind kind) {
  DrawnNumber drawn;
  const int sign = dice.chance(4) ? -1 : 1;
  if (kind == NumberKind::ones && dice.chance(2)) return {1};
  if (dice.chance(10)) return drawn;
  if (kind == NumberKind::integers) return {sign * dice.number(1, 6)};
  if (kind == NumberKind::ones) {
    drawn.numerator = sign * dice.number(1, 3);
    drawn.denominator = dice.number(1, 3);
    return drawn;
  }
  drawn.denominator = dice.number(1, largest_denominator);
  drawn.numerator = sign * dice.number(1, largest_numerator);
  const int power = kind == NumberKind::wide ? 20 : kind == NumberKind::extreme ? 40 : 0;
  if (power > 0 && !dice.chance(2)) drawn.exponent = dice.number(-power, power);
  return drawn;
}

/// No possible denominator makes x an integer, or an integer times a power of two, and the difference is far larger
/// than x's error and the roundings here.
bool may_be_drawn(const Approximate& x, NumberKind kind) {
  constexpr double margin = 1e-6;
  for (int denominator = 1; denominator <= largest_denominator; ++denominator) {
    double scale = denominator;
    if (kind == NumberKind::wide || kind == NumberKind::extreme) {
      int exponent = 0;
      std::frexp(x.value * scale, &exponent);
      scale = std::ldexp(scale, 4 - exponent);  // numerators have four bits
    }
    const double numerator = x.value * scale;
    if (!(std::fabs(numerator - std::nearbyint(numerator)) > margin + x.error * scale)) return true;
  }
  return false;
}

}  // namespace slipproof
