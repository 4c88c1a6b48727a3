// Impacts in space whose outcome is worked out by hand.
#include <doctest/doctest.h>

#include "base/input/diagnostic.hpp"
#include "contact/impact/impact_of.hpp"
#include "contact/space/solve_space.hpp"

using namespace slipproof;
using test::after;
using test::impulse;

namespace {

/// A solid ball of radius 1 and mass 1 that hits the floor at (1, 2, -1) with a spin about its own normal.
SolvedImpact thrown_ball(const std::string& mu, const std::string& more = "", std::optional<ImpactLaw> law = {}) {
  return test::impact_of_text(R"(
dimension = 3
[[body]]
name = "ball"
mass = "1"
inertia = ["2/5", "2/5", "2/5"]
at = ["0", "0", "1"]
velocity = ["1", "2", "-1"]
spin = ["0", "0", "3"]
[[contact]]
name = "floor"
of = "ball"
point = ["0", "0", "0"]
radius = "1"
normal = ["0", "0", "1"]
through = ["0", "0", "0"]
tangent = ["1", "0", "0"]
restitution = "1/2"
friction = ")" + mu + "\"\n" + more,
                              law);
}

bool contains(const Range& range, const Rational& lower, const Rational& upper) {
  return *range.lower <= upper && lower <= *range.upper && *range.upper - *range.lower < Rational(1, 1'000'000);
}

}  // namespace

TEST_CASE("a ball that is thrown on a rough floor rolls away, its spin about the normal unchanged") {
  for (const ImpactLaw law : {ImpactLaw::newton, ImpactLaw::moreau}) {
    const SolvedImpact ball = thrown_ball("1", "", law);
    CHECK(ball.complete());
    CHECK(impulse(ball, "N_floor") == Rational(3, 2));
    CHECK(impulse(ball, "T1_floor") == Rational(-2, 7));
    CHECK(impulse(ball, "T2_floor") == Rational(-4, 7));
    CHECK(after(ball, "vx") == Rational(5, 7));
    CHECK(after(ball, "vy") == Rational(10, 7));
    CHECK(after(ball, "vz") == Rational(1, 2));
    CHECK(after(ball, "omegax") == Rational(-10, 7));
    CHECK(after(ball, "omegay") == Rational(5, 7));
    CHECK(after(ball, "omegaz") == 3);
    CHECK(ball.outcomes.front().gains == false);
    // (25 + 100)/49 + 1/4 + 2/5 (125/49 + 9), and half of it
    CHECK(*ball.outcomes.front().energy.lower ==
          (Rational(125, 49) + Rational(1, 4) + Rational(2, 5) * (Rational(125, 49) + 9)) / 2);
  }
}

TEST_CASE("on a slippery floor it slides on in the direction in which it slid") {
  const SolvedImpact ball = thrown_ball("1/10");
  REQUIRE(ball.outcomes.size() == 1);
  // T = -mu N (1, 2)/sqrt(5), with mu N = 3/20 and 1/sqrt(5) = 0.4472135954...
  const Rational low("4472135954/10000000000"), high("4472135955/10000000000"), limit(3, 20);
  CHECK(contains(test::range_after(ball, ball.outcomes.front(), "vx"), 1 - limit * high, 1 - limit * low));
  CHECK(contains(test::range_after(ball, ball.outcomes.front(), "vy"), 2 - 2 * limit * high, 2 - 2 * limit * low));
  CHECK(ball.outcomes.front().gains == false);
}

TEST_CASE("a tangential restitution throws a super ball back in space") {
  const SolvedImpact ball = thrown_ball("2", "tangential_restitution = \"1\"\n");
  CHECK(after(ball, "vx") == Rational(3, 7));
  CHECK(after(ball, "vy") == Rational(6, 7));
  CHECK(after(ball, "slip_floor") == 0);  // the law's own slip: after + before
  CHECK(after(ball, "omegax") == Rational(-20, 7));
  CHECK(after(ball, "omegay") == Rational(10, 7));
}

TEST_CASE("by Poisson's law in space a rod in a plane has the outcome that it has in the plane") {
  const SolvedImpact rod = test::impact_of_text(R"(
dimension = 3
[[body]]
name = "rod"
mass = "1"
inertia = ["1/3", "1/3", "1/3"]
at = ["3/5", "0", "4/5"]
velocity = ["1/5", "0", "-2/5"]
spin = ["0", "-1", "0"]
[[contact]]
name = "foot"
of = "rod"
point = ["-3/5", "0", "-4/5"]
normal = ["0", "0", "1"]
through = ["0", "0", "0"]
tangent = ["1", "0", "0"]
restitution = "1"
friction = "1"
)",
                                                ImpactLaw::poisson);
  CHECK(rod.complete());
  // rod-that-gains.toml in cases/impact, by Poisson's law
  CHECK(impulse(rod, "N_foot") == Rational(37, 50));
  CHECK(impulse(rod, "T1_foot") == Rational(41, 1825));
  CHECK(impulse(rod, "T2_foot") == 0);
  CHECK(after(rod, "vx") == Rational(406, 1825));
  CHECK(after(rod, "vz") == Rational(17, 50));
  CHECK(after(rod, "omegay") == Rational(203, 730));
  CHECK(rod.outcomes.front().modes.front() == "lift after stick");
  CHECK(test::energy_after(rod) == Rational(209, 2190));
}

TEST_CASE("by Poisson's law in space a ball slides on along its direction, and restitution has its own friction") {
  const SolvedImpact ball = thrown_ball("1/10", "", ImpactLaw::poisson);  // one contact: Newton's outcome
  REQUIRE(ball.outcomes.size() == 1);
  const Rational low("4472135954/10000000000"), high("4472135955/10000000000"), limit(3, 20);
  CHECK(contains(test::range_after(ball, ball.outcomes.front(), "vx"), 1 - limit * high, 1 - limit * low));
  CHECK(contains(test::range_after(ball, ball.outcomes.front(), "vy"), 2 - 2 * limit * high, 2 - 2 * limit * low));
  // It slides in compression, mu < 2/7 sqrt(5), and stops in restitution, 3/2 mu > 2/7 sqrt(5).
  const SolvedImpact stops = thrown_ball("1/2", "", ImpactLaw::poisson);
  REQUIRE(stops.outcomes.size() == 1);
  CHECK(contains(test::range_after(stops, stops.outcomes.front(), "vx"), Rational(5, 7), Rational(5, 7)));
  CHECK(stops.outcomes.front().modes.front() == "lift after slip");
}

TEST_CASE("what has one phase refuses Poisson's law in space") {
  const SolvedImpact ball = thrown_ball("1", "", ImpactLaw::poisson);
  CHECK_THROWS_WITH_AS(solve_space(ball.scene), doctest::Contains("Poisson's law, whose two phases"), InputError);
}
