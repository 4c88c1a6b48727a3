// Angles of directions, enclosed.
#include "mechanics/points/degrees.hpp"

#include <doctest/doctest.h>

#include "base/number/parse.hpp"

using namespace slipproof;

TEST_CASE("angles of directions are enclosed to as many decimals as one wants, exact where they are rational") {
  const auto [low, high] = degrees_of_direction(4, 3, 30);
  CHECK(low == parse_rational("36.869897645844021296855612559093"));  // arctan(3/4)
  CHECK(high - low == parse_rational("1e-30"));
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 1}) {
      if (x == 0 && y == 0) continue;
      const auto [from, to] = degrees_of_direction(x * Rational(7, 3), y * Rational(7, 3), 5);
      CHECK(from == to);
      CHECK(denominator(from / 45) == 1);
    }
  }
  CHECK(degrees_of_direction(-2, 0, 5).first == 180);
  CHECK(degrees_of_direction(1, -1, 5).first == -45);
}

TEST_CASE("angles keep their order in all quarters") {
  std::optional<Rational> before;
  for (const auto& [x, y] : {std::pair{-3, -1}, {-1, -3}, {1, -3}, {3, -1}, {3, 1}, {1, 3}, {-1, 3}, {-3, 1}}) {
    const auto [low, high] = degrees_of_direction(x, y, 40);
    CHECK(low < high);
    if (before) CHECK(*before < low);
    before = high;
  }
  const auto [small, next] = degrees_of_direction(1, parse_rational("1e-25"), 40);
  CHECK(small > 0);
  CHECK(next < parse_rational("1e-23"));
}
