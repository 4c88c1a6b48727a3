#include "mechanics/bicycle_modes/continuum.hpp"

#include <doctest/doctest.h>

#include "mechanics/bicycle/conditions.hpp"
#include "mechanics/bicycle_modes/motions.hpp"
#include "support/random_scene.hpp"
#include "support/unknowns.hpp"

using namespace slipproof;
using slipproof::test::RandomScenes;

namespace {

constexpr ContactMode stick_slip{ContactState::stick, ContactState::slip_forward};

Motion<Rational> member(const Continuum& c, const Rational& F, const std::vector<Rational>& t) {
  Motion<Rational> m;
  for (const Quantity q : all_quantities()) {
    m[q] = c.base[q].at(F);
    for (std::size_t k = 0; k < t.size(); ++k) m[q] += t[k] * c.directions[k][q];
  }
  return m;
}

void check_equations(const Bicycle<Rational>& p, const Road<Rational>& road, const Continuum& c, const Rational& F,
                     const Motion<Rational>& m) {
  const auto u = test::unknowns(p, F, m);
  for (const Rational& r : equations_of_motion(p, road, ForceKind::internal, u, F)) CHECK(r == 0);
  for (const Wheel w : {Wheel::rear, Wheel::front}) {
    for (const Rational& r : contact_equations(p, road, u, w, c.mode[w])) CHECK(r == 0);
  }
}

}  // namespace

TEST_CASE("b = b1: slip of the front wheel exists at one force only, as a continuum in N3") {
  RandomScenes random(31);
  for (int i = 0; i < 40; ++i) {
    auto p = random.reduced(i % 2 == 0);
    p.h = random.positive();
    const auto road = random.road();
    const Rational M1 = 1 + p.I2 / (p.R * p.R);
    p.b2 = p.b3 = road.f * p.h / (2 * M1);
    const ModeTable table(p, road, ForceKind::internal);
    const ModeSolution& s = *table.find(stick_slip);
    REQUIRE(s.kind() == ModeSolution::Kind::continuum);
    const Rational F0 = road.f * road.g * p.h / (2 * (M1 * p.R + p.h));
    CHECK(s.closed() == ForceInterval::point(F0));
    CHECK(s.strict() == ForceInterval::point(F0));
    const Continuum& c = s.continuum();
    REQUIRE(c.directions.size() == 1);
    CHECK(c.parameters == std::vector<Quantity>{Quantity::N3});
    const auto ranges = c.parameter_ranges(F0);
    REQUIRE(ranges);
    REQUIRE(ranges->front().lower());
    REQUIRE(ranges->front().upper());
    CHECK(*ranges->front().lower() == 0);  // N3 = 0 at one end: where the front wheel begins to lift
    for (const Rational& t : {*ranges->front().lower(), ranges->front().sample(), *ranges->front().upper()}) {
      const auto m = member(c, F0, {t});
      check_equations(p, road, c, F0, m);
      for (const Condition& condition : conditions(c.mode)) CHECK(condition_value(condition, m, road.f) >= 0);
    }
    bool left = false;  // just beyond the end some condition fails
    const auto beyond = member(c, F0, {*ranges->front().upper() + Rational(1, 1000)});
    for (const Condition& condition : conditions(c.mode)) left = left || condition_value(condition, beyond, road.f) < 0;
    CHECK(left);
    const auto found = motions_at(table, F0);
    REQUIRE(found.continua.size() == 1);
    CHECK(found.continua.front().strict);
  }
}

TEST_CASE("a wheel without inertia that slips or hangs in the air may spin as it likes, and the answer says so") {
  RandomScenes random(32);
  for (int i = 0; i < 30; ++i) {
    auto p = random.bicycle(true);
    p.I3 = 0;
    const auto road = random.road();
    const ModeTable table(p, road, ForceKind::internal);
    for (const ModeSolution& s : table.solutions()) {
      if (s.mode().front == ContactState::stick) {
        CHECK(s.kind() == ModeSolution::Kind::regular);
        CHECK(s.quantity(Quantity::S3) == Affine<Rational>(0, 0));
        continue;
      }
      REQUIRE(s.kind() == ModeSolution::Kind::continuum);
      CHECK(s.continuum().undetermined() == std::vector<Quantity>{Quantity::eps3, Quantity::slip3});
      const Rational F = random.any();
      if (s.continuum().solvable.contains(F)) check_equations(p, road, s.continuum(), F, member(s.continuum(), F, {7}));
    }
  }
}

TEST_CASE("both wheels without inertia: two free parameters, or forces that the massless rear wheel cannot take") {
  RandomScenes random(33);
  auto p = random.bicycle(true);
  p.I1 = p.I2 = p.I3 = 0;
  p.L = 1;
  const Road<Rational> road{1, 1};
  const ModeTable table(p, road, ForceKind::internal);
  const ModeSolution& both_off = *table.find({ContactState::lift, ContactState::lift});
  REQUIRE(both_off.kind() == ModeSolution::Kind::continuum);
  CHECK(both_off.continuum().solvable ==
        ForceInterval::point(0));  // a drive moment on a wheel with no inertia in the air
  CHECK(both_off.continuum().directions.size() == 2);
}

TEST_CASE("a regular mode solved as if it were singular gives the same motion and the same forces") {
  RandomScenes random(34);
  for (int i = 0; i < 30; ++i) {
    const auto p = random.bicycle(true);
    const auto road = random.road();
    const ModeTable table(p, road, ForceKind::external);
    for (const ModeSolution& s : table.solutions()) {
      if (s.kind() != ModeSolution::Kind::regular) continue;
      const auto c = SingularModes(p, road, ForceKind::external).solve(s.mode());
      REQUIRE(c);
      CHECK(c->directions.empty());
      CHECK(c->base == s.motion());
      CHECK(c->closed == s.closed());
      CHECK(c->strict == s.strict());
    }
  }
}
