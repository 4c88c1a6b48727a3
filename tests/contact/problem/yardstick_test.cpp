#include "contact/problem/yardstick.hpp"

#include <doctest/doctest.h>

#include "contact/problem/solutions.hpp"

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
  Effort effort(ContactSolver::default_effort);
  const auto t = nearest_solution(components, {{0, {1}}, {1, {-1}}}, 1, effort);
  CHECK(t == std::vector{tiny / 2});
  // With y in thousandths of its unit the same one.
  const auto same =
      nearest_solution({{{1, {-1}}, 1, 1}, {{0, {1000}}, tiny * 1000, 1000}}, {{0, {1}}, {1, {-1}}}, 1, effort);
  CHECK(same == t);
  CHECK(nearest_solution({}, {{-3, {1}}}, 1, effort).at(0) >= 3);
}

TEST_CASE("no other solution is nearer than the nearest one") {
  // Three forces with x + y + z = 3 and 0 <= x <= y: parameters x, y.
  const std::vector<AffineForm> forms{{0, {1, 0}}, {0, {0, 1}}, {3, {-1, -1}}}, conditions{{0, {1, 0}}, {0, {-1, 1}}};
  const std::vector<std::vector<Rational>> answers{
      {1, 1, 1}, {2, 1, 0}, {Rational(1, 1000), 5, -2}, {-1, Rational(1, 7), 4}, {100, 100, -197}};
  Effort effort(ContactSolver::default_effort);
  for (const auto& answer : answers) {
    Yardsticks yardstick(1);
    for (const Rational& x : answer) yardstick.take(0, x);
    const auto distance = [&](const std::vector<Rational>& t) {
      Distance d{0, 0};
      for (std::size_t i = 0; i < 3; ++i) compare({answer[i], forms[i].at(t), yardstick[0], true}, d);
      return d.relative;
    };
    std::vector<OpenComponent> open;
    for (std::size_t i = 0; i < 3; ++i) open.push_back({forms[i], answer[i], yardstick[0]});
    const auto best = nearest_solution(open, conditions, 2, effort);
    for (const AffineForm& condition : conditions) CHECK(condition.at(best).sign() >= 0);
    bool nearer = false;
    for (int x = 0; x <= 40; ++x) {
      for (int y = x; y <= 80; ++y) nearer = nearer || distance({Rational(x, 8), Rational(y, 8)}) < distance(best);
    }
    CHECK_FALSE(nearer);
  }
}

TEST_CASE("a solution within the tolerance is meant before one that is nearer only for its largest components") {
  const Distance accurate{Rational(1, 1000), Rational(1, 1000)}, near{1, Rational(1, 10000)};
  CHECK(is_nearer(accurate, near, Rational(1, 100)));
  CHECK_FALSE(is_nearer(near, accurate, Rational(1, 100)));
  CHECK(is_nearer(near, accurate, Rational(1, 100000)));
}
