// What is certified is so: against problems whose exact solution is known.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/number/binary64.hpp"
#include "contact/judge/judge.hpp"
#include "known_problem.hpp"
#include "support/how_many.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

int problems() {
  return test::how_many("SLIPPROOF_KNOWN_PROBLEMS", 100);
}

/// Small ones often, up to 200 contacts.
std::size_t some_contacts(Dice& dice) {
  return static_cast<std::size_t>(dice.chance(25) ? dice.number(50, 200) : dice.number(1, dice.chance(4) ? 40 : 6));
}

bool contains(const Enclosure& box, const std::vector<double>& x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t j = box.system.unknown(i);
    const Rational center = j == ModeSystem::none ? Rational(0) : to_rational(box.center[j]);
    const Rational radius = j == ModeSystem::none ? Rational(0) : to_rational(box.radius[j]);
    if (abs(to_rational(x[i]) - center) > radius) return false;
  }
  return true;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) result = std::max(result, std::abs(a[i] - b[i]));
  return result;
}

}  // namespace

TEST_CASE("enclosures contain the solution that a problem was made from") {
  int enclosed = 0, all = 0;
  for (int i = 0; i < problems(); ++i) {
    Dice dice(17, static_cast<std::uint64_t>(i));
    const KnownProblem known = known_problem(dice, some_contacts(dice));
    std::vector<double> answer = known.x;
    for (double& x : answer) x *= 1 + dice.number(-1000, 1000) * 1e-13;
    ContactJudgeOptions options;
    options.refine = true;
    const ContactJudgement found = judge_contacts(known.problem, answer, {}, options);
    ++all;
    REQUIRE(found.residual);
    CHECK(found.residual->backward_error() < 1e-9);
    if (!found.enclosure) continue;
    ++enclosed;
    CHECK(found.verdict == ContactVerdict::solution_within_rho);
    CHECK(contains(*found.enclosure, known.x));
    CHECK(found.rho >= distance(answer, known.x));
    CHECK(found.rho <= 4 * distance(answer, known.x) + 1e-9);
    CHECK(found.enclosure->locally_unique);
    CHECK((found.enclosure->system.mode() == known.mode));
  }
  CHECK(enclosed == all);
}

TEST_CASE("the solution itself has no residual, and no exclusion") {
  for (int i = 0; i < 40; ++i) {
    Dice dice(18, static_cast<std::uint64_t>(i));
    const KnownProblem known = known_problem(dice, some_contacts(dice));
    const std::vector<Rational> w = exact_rows(known.problem, known.x);
    const Residual r = residual(known.problem, known.x, w);
    // A rational direction is not the Pythagorean one: what is rounded there is all that is left.
    CHECK(r.backward_error() < 1e-14);
    CHECK(r.moved < 1e-11);
    CHECK(exclusion(known.problem, known.x, w).radius == 0);
  }
}

TEST_CASE("a spoiled answer is never certified closer than it is") {
  int rejected = 0, all = 0;
  for (int i = 0; all < problems(); ++i) {
    Dice dice(19, static_cast<std::uint64_t>(i));
    const KnownProblem known = known_problem(dice, some_contacts(dice));
    std::vector<double> answer = known.x;
    const auto k = static_cast<std::size_t>(dice.number(0, static_cast<int>(known.problem.contacts()) - 1));
    const std::size_t first = known.problem.normal(k);
    switch (dice.number(0, 4)) {
      case 0:
        answer[first + static_cast<std::size_t>(dice.number(0, 2))] += dice.chance(2) ? 0.01 : -3;
        break;
      case 1:
        for (double& x : answer) x *= 1.001;
        break;
      case 2:
        std::swap(answer[first + 1], answer[first + 2]);
        break;
      case 3:  // from one mode to another
        for (std::size_t j = 0; j < 3; ++j) answer[first + j] = known.x[first] == 0 && j == 0 ? 1 : 0;
        break;
      default:
        answer[first] = dice.chance(2) ? std::nan("") : std::numeric_limits<double>::infinity();
    }
    if (answer == known.x) continue;
    ++all;
    const bool finite = std::isfinite(answer[first]);
    const double apart = distance(answer, known.x);
    ContactJudgeOptions options;
    options.refine = dice.chance(2);
    options.tolerance = dice.chance(2) ? 1e-9 : 1e-4;
    const ContactJudgement found = judge_contacts(known.problem, answer, {}, options);
    if (!finite) {
      CHECK(found.verdict == ContactVerdict::invalid);
      continue;
    }
    using enum ContactVerdict;
    if (found.verdict == wrong || found.verdict == not_converged || found.verdict == inaccurate) ++rejected;
    double largest = 0;
    for (const double x : known.x) largest = std::max(largest, std::abs(x));
    if (is_certified(found.verdict) && largest > 0) CHECK(apart <= options.tolerance * largest * (1 + 1e-9));
    CHECK(found.verdict != ContactVerdict::unique);
    if (found.enclosure) CHECK(found.rho >= apart * (1 - 1e-12));
    // The solution is the only one: what is excluded cannot reach it.
    REQUIRE(found.exclusion);
    CHECK(found.exclusion->radius <= apart);
  }
  CHECK(rejected > all / 3);
}
