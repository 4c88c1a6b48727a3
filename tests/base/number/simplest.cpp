#include "base/number/simplest.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace slipproof;

namespace {

/// By trying every denominator from 1 up, and for each the numerators by absolute value.
Rational by_search(const Rational& lower, const Rational& upper) {
  for (int d = 1;; ++d) {
    for (int n = 0; n <= 400 * d; ++n) {
      for (const int s : {1, -1}) {
        const Rational x(s * n, d);
        if (lower < x && x < upper) return x;
      }
    }
  }
}

}  // namespace

TEST_CASE("the simplest rational between two ends is the one that a search finds") {
  std::mt19937 engine(7);
  const auto number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine); };
  for (int i = 0; i < 2000; ++i) {
    const Rational x(number(-300, 300), number(1, 60)), y(number(-300, 300), number(1, 60));
    if (x == y) continue;
    const Rational &lower = x < y ? x : y, &upper = x < y ? y : x;
    CHECK(simplest_between(lower, upper) == by_search(lower, upper));
  }
}

TEST_CASE("infinite ends, and nothing between") {
  CHECK(simplest_between(std::nullopt, std::nullopt) == 0);
  CHECK(simplest_between(Rational(0), std::nullopt) == 1);
  CHECK(simplest_between(Rational(7, 2), std::nullopt) == 4);
  CHECK(simplest_between(std::nullopt, Rational(-7, 2)) == -4);
  CHECK(simplest_between(Rational(1, 3), Rational(1, 2)) == Rational(2, 5));
  CHECK_THROWS_AS(simplest_between(Rational(1), Rational(1)), std::invalid_argument);
  CHECK(height(Rational(-7, 2)) == 7);
  CHECK(height(Rational(2, 9)) == 9);
  CHECK(height(Rational(0)) == 1);
}
