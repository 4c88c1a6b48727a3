// V of proofs/rest-on-slope falls along random motions, through impacts in random orders, and all come to rest.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "mechanics/rest_on_slope/map_picture.hpp"
#include "mechanics/rest_on_slope/motion.hpp"
#include "mechanics/rest_on_slope/shipped.hpp"
#include "support/files/made_again.hpp"
#include "support/how_many.hpp"

namespace slipproof::test::rest_on_slope {

namespace {

constexpr int limit = 20000;  // steps of a motion
const Body tipping{0.8, 0.5, 0.5, 0.5, 0};

/// A number of the interval; each end one time in four.
double with_ends(Dice& dice, double low, double high) {
  const int kind = dice.number(0, 3);
  return kind == 0 ? low : kind == 1 ? high : between(dice, low, high);
}

/// In the region 1/3 <= J <= 2/3, |u| + mu h <= 1/2, mu <= 1, often on its edges.
Body low_body(Dice& dice) {
  Body body;
  body.J = with_ends(dice, 1. / 3, 2. / 3);
  body.mu = dice.chance(3) ? 1 : between(dice, 0.02, 1);
  body.u = dice.chance(4) ? 0 : with_ends(dice, -0.5, 0.5);
  body.h = with_ends(dice, 0, 0.5 - std::abs(body.u)) / body.mu;
  return body;
}

/// A slope below the coefficient of friction; 0 one time in six.
double slope_below(Dice& dice, double mu) {
  return dice.chance(6) ? 0 : mu * between(dice, -0.99, 0.99);
}

double kappa_above(Dice& dice, const Body& body) {
  const double t = std::abs(body.t);
  return dice.chance(3) ? body.mu : t + (body.mu - t) * between(dice, 0.01, 1);
}

double power(Dice& dice) {
  return std::pow(10, -dice.number(0, 3));
}

/// Feet on the ground or above it, velocities of either sign, of similar or of different sizes, or 0, but not at rest.
State random_state(Dice& dice) {
  State result;
  while (result.at_rest()) {
    for (double& v : result.velocity) v = dice.chance(5) ? 0 : between(dice, -1, 1) * power(dice);
    for (const std::size_t i : feet) result.at[i] = dice.chance(2) ? 0 : between(dice, 0, 1) * power(dice);
  }
  return result;
}

/// Checks motions and counts what was seen.
class Tally {
 public:
  void check(const Body& body, const Falling& falling, int motions, Dice& dice) {
    CHECK_MESSAGE(falling.rate > 0, text(body));
    for (int i = 0; i < motions; ++i) {
      const State state = random_state(dice);
      const double start = falling.value(state);
      const Seen seen = follow(body, falling, state, dice, limit);
      CHECK_MESSAGE(seen.rise.empty(), seen.rise);
      CHECK_MESSAGE(seen.rests, text(body) << "; from " << text(state));
      CHECK(falling.rate * seen.way <= (1 + 1e-9) * start);
      ++motions_;
      stretches_ += seen.stretches;
      hits_ += seen.hits;
      longest_ = std::max(longest_, seen.stretches + seen.hits);
      slack_ = std::max(slack_, seen.slack);
    }
    const std::vector<Triple> rest = accelerations(body, {});
    CHECK(!rest.empty());
    for (const Triple& a : rest) CHECK_MESSAGE(std::abs(a[0]) + a[1] + a[2] < 1e-12, text(body));
  }
  ~Tally() {
    MESSAGE(motions_ << " motions, " << stretches_ << " stretches and " << hits_ << " parts of impacts, at most "
                     << longest_ << " in a motion; V rises by at most " << slack_ << " of itself, by rounding");
  }

 private:
  std::int64_t motions_ = 0, stretches_ = 0, hits_ = 0;
  int longest_ = 0;
  double slack_ = 0;
};

/// How many of the region's bodies have a motion along which V with other numbers rises.
int rising(Numbers numbers, double kappa_times) {
  int result = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Dice dice(62, i);
    Body body = low_body(dice);
    body.t = slope_below(dice, body.mu);
    Falling changed = falling(body, numbers, kappa_times * kappa_above(dice, body));
    changed.rate = 0;
    bool rises = false;
    for (int motion = 0; motion < 20 && !rises; ++motion) {
      rises = !follow(body, changed, random_state(dice), dice, limit).rise.empty();
    }
    result += rises ? 1 : 0;
  }
  return result;
}

}  // namespace

TEST_CASE("V falls by hand as the README says") {
  const Body body{0, 1, 0.5, 0.5, 0};
  const Falling v = falling(body, shipped_numbers(), 0.25);
  CHECK(v.value({{}, {1, -1, 0}}) == doctest::Approx(35. / 16));
  CHECK(v.value({{}, {0.125, 0, -0.5}}) == doctest::Approx(39. / 64));
  const Contact slides(body, {}, 1);
  const Triple change = slides.acceleration(slides.with_friction({0, 0.25, 0}));
  CHECK(change[0] == doctest::Approx(-0.875));
  CHECK(change[1] == doctest::Approx(1));
  CHECK(change[2] == doctest::Approx(-0.5));
}

TEST_CASE("on level ground the energy of the simulated bodies does not rise") {
  for (std::uint64_t i = 0; i < 500; ++i) {
    Dice dice(63, i);
    const Body body = low_body(dice);
    const Seen seen = follow(body, falling(body, {}, 0), random_state(dice), dice, limit);  // V is the energy
    CHECK_MESSAGE(seen.rise.empty(), seen.rise);
    CHECK(seen.rests);
  }
}

TEST_CASE("low bodies: V falls along random motions, and they come to rest") {
  const Numbers numbers = shipped_numbers();
  Tally tally;
  const auto bodies = test::how_many("SLIPPROOF_RESTING_BODIES", std::uint64_t{5000});
  for (std::uint64_t i = 0; i < bodies; ++i) {
    Dice dice(59, i);
    Body body = low_body(dice);
    body.t = slope_below(dice, body.mu);
    tally.check(body, falling(body, numbers, kappa_above(dice, body)), 10, dice);
  }
}

TEST_CASE("the points beyond: V falls along random motions, and they come to rest") {
  const std::vector<Point> points = shipped_points();
  CHECK(points.size() == 15);
  Tally tally;
  const auto slopes = test::how_many("SLIPPROOF_RESTING_BODIES", std::uint64_t{5000}) / 15;
  for (const Point& point : points) {
    CAPTURE(point.id);
    for (std::uint64_t i = 0; i < slopes; ++i) {
      Dice dice(60, i);
      Body body = point.body;
      body.t = slope_below(dice, body.mu);
      tally.check(body, falling(body, point.numbers, kappa_above(dice, body)), 10, dice);
    }
  }
}

TEST_CASE("the body that tips while it slides: V falls along random motions, and they come to rest") {
  Tally tally;
  const auto slopes = test::how_many("SLIPPROOF_RESTING_BODIES", std::uint64_t{5000}) / 10;
  for (std::uint64_t i = 0; i < slopes; ++i) {
    Dice dice(61, i);
    Body body = tipping;
    body.t = with_ends(dice, -0.1, 0.1);
    tally.check(body, falling_beyond(), 10, dice);
  }
}

TEST_CASE("the map of rest on a slope is that of its points") {
  const std::string contents = map_picture(shipped_points(), tipping);
  CHECK(is_made_again(SLIPPROOF_SOURCE_DIR "/proofs/rest-on-slope/map.svg", contents));
}

TEST_CASE("V without one of its terms rises") {
  const Numbers numbers = shipped_numbers();
  Numbers without_b = numbers, without_e = numbers;
  without_b.B1 = without_b.B2 = 0;
  without_e.E = 0;
  CHECK(rising(numbers, 1) == 0);
  const int b = rising(without_b, 1), e = rising(without_e, 1), kappa = rising(numbers, 0);
  CHECK(b > 50);
  CHECK(e > 50);
  CHECK(kappa > 20);
  MESSAGE("V rises for " << b << " of 100 bodies without B1 and B2, " << e << " without E, " << kappa
                         << " without kappa");
}

}  // namespace slipproof::test::rest_on_slope
