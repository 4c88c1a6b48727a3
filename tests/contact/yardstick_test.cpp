#include "contact/yardstick.hpp"

#include <doctest/doctest.h>

#include "contact/solutions.hpp"

using namespace slipproof;

namespace {

Distance distance_of(const ComparedComponent& component) {
  Distance d{0, 0};
  compare(component, d);
  return d;
}

}  // namespace

TEST_CASE("an error is relative to the exact value, and that of an exact 0 to the yardstick of its kind") {
  Yardsticks yardsticks(2);
  yardsticks.take(0, -1000);
  yardsticks.take(0, 10);
  CHECK(yardsticks[0] == 1000);
  CHECK(yardsticks[1] == 0);
  CHECK(distance_of({11, 10, 1000}).relative == Rational(1, 10));
  CHECK(distance_of({11, 10, 1000}).scaled == Rational(1, 1000));
  CHECK(distance_of({1, 0, 1000}).relative == Rational(1, 1000));
  CHECK(distance_of({11, 10, 1000, true}).relative == Rational(1, 1000));
  CHECK(distance_of({0, 0, 0}).relative == 0);
  CHECK(distance_of({Rational(1, 1000000), 0, 0}).relative == 1);  // nothing but 0 is right
}

TEST_CASE("no unit changes an error") {
  for (const Rational& unit : {Rational(1, 1000), Rational(7, 3), Rational(1000000)}) {
    for (const Rational& exact : {Rational(0), Rational(5), Rational(-3, 7)}) {
      for (const Rational& yardstick : {Rational(0), Rational(2), Rational(100)}) {
        for (const bool open : {false, true}) {
          const Rational answer(21, 20);
          const Distance plain = distance_of({answer, exact, yardstick, open});
          const Distance scaled = distance_of({answer * unit, exact * unit, yardstick * unit, open});
          CHECK(plain.relative == scaled.relative);
          CHECK(plain.scaled == scaled.scaled);
        }
      }
    }
  }
}

TEST_CASE("the nearest of many solutions is the best of them, whatever their sizes") {
  // x + y = 1, x >= 0, y >= 0: the answer (1, 1e-17) is within 1e-17 of one of them.
  const Rational tiny = Rational(1) / Rational("100000000000000000");
  const std::vector<OpenComponent> components{{{1, {-1}}, 1, 1}, {{0, {1}}, tiny, 1}};
  Effort effort(ContactSolver::usual_effort);
  const auto t = nearest_solution(components, {{0, {1}}, {1, {-1}}}, 1, effort);
  CHECK(t == std::vector{tiny / 2});
  // With y in thousandths of its unit the same one.
  const auto same =
      nearest_solution({{{1, {-1}}, 1, 1}, {{0, {1000}}, tiny * 1000, 1000}}, {{0, {1}}, {1, {-1}}}, 1, effort);
  CHECK(same == t);
  CHECK(nearest_solution({}, {{-3, {1}}}, 1, effort).at(0) >= 3);
}
