// Random rational scenes for tests: small heights, every sign that the domain admits, a fixed seed.
#pragma once

#include <random>

#include "support/bicycle/bicycle.hpp"

namespace slipproof::test {

class RandomScenes {
 public:
  explicit RandomScenes(std::uint32_t seed) : engine_(seed) {}

  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  /// The numerator in [low, high] over at most 20. Two draws in one call's arguments would come in the compiler's
  /// order.
  Rational fraction(int low, int high) {
    const int denominator = integer(1, 20);
    return Rational(integer(low, high), denominator);
  }
  Rational positive() { return fraction(1, 40); }
  Rational any() { return fraction(-40, 40); }

  /// Any mu, b2 != b3, any M; h of every sign; L of every sign.
  Bicycle<Rational> bicycle(bool with_J) {
    Bicycle<Rational> p;
    p.M = positive();
    p.R = positive();
    p.h = positive() - p.R;
    p.b2 = positive() - Rational(integer(0, 1), 4);
    p.b3 = positive();
    p.I1 = fraction(0, 10);
    p.I2 = positive();
    p.I3 = positive();
    p.r1 = positive();
    p.r2 = positive();
    p.L = any();
    if (with_J) p.J = positive();
    return p;
  }

  /// Section 3 of the paper: M = 1, mu = 1, b2 = b3; then P = F sigma = F L / R.
  Bicycle<Rational> reduced(bool with_J) {
    Bicycle<Rational> p = bicycle(with_J);
    p.M = 1;
    p.r2 = p.r1;
    p.b2 = p.b3;
    p.I1 = 0;
    p.L = p.R;
    return p;
  }

  Road<Rational> road() { return {positive(), positive()}; }

 private:
  std::mt19937 engine_;
};

}  // namespace slipproof::test
