#include "mechanics/elements/force_interval.hpp"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using namespace slipproof;

TEST_CASE("restrictions that do not depend on the force: all or nothing, zero is not strictly positive") {
  for (const int alpha : {-1, 0, 1}) {
    for (const bool strict : {false, true}) {
      ForceInterval all;
      all.restrict_to({Rational(alpha), Rational(0)}, strict);
      CHECK(all.empty() == (alpha < 0 || (strict && alpha == 0)));
    }
  }
}

TEST_CASE("intersections and restrictions contain what their parts contain, ends included") {
  std::mt19937 engine(3);
  const auto number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine); };
  for (int i = 0; i < 1000; ++i) {
    ForceInterval interval;
    std::vector<std::pair<Affine<Rational>, bool>> conditions;
    for (int k = 0; k < 4; ++k) {
      const Rational alpha = number(-3, 3), beta = number(-2, 2);
      const bool strict = number(0, 1) == 1;
      conditions.emplace_back(Affine<Rational>(alpha, beta), strict);
      ForceInterval one;
      one.restrict_to({alpha, beta}, strict);
      if (number(0, 1) == 1) {
        interval.intersect(one);
      } else {
        interval.restrict_to({alpha, beta}, strict);
      }
    }
    bool any = false;
    for (int n = -24; n <= 24; ++n) {  // ends are multiples of 1/2: 1/4 is fine enough to see every interval
      const Rational F(n, 4);
      bool inside = true;
      for (const auto& c : conditions) {
        const Rational value = c.first.at(F);
        inside = inside && (c.second ? value > 0 : value >= 0);
      }
      any = any || inside;
      CHECK(interval.contains(F) == inside);
    }
    CHECK(interval.empty() != any);
    if (any) CHECK(interval.contains(interval.sample()));
    CHECK(interval.is_point() == (any && interval.interior().empty()));
  }
}

TEST_CASE("as text") {
  CHECK(to_string(ForceInterval()) == "(-oo, +oo)");
  CHECK(to_string(ForceInterval::nothing()) == "{}");
  CHECK(to_string(ForceInterval::point(Rational(5, 3))) == "{5/3}");
  CHECK(to_string(ForceInterval::between(Rational(1, 2), true, std::nullopt, false)) == "[1/2, +oo)");
  CHECK(ForceInterval::between(Rational(1), true, Rational(1), false).empty());
}
