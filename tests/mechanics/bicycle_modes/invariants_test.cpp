// Properties that any correct solver has: symmetry, units, limits, statics.
#include <doctest/doctest.h>

#include "mechanics/bicycle_modes/motions.hpp"
#include "support/random_scene.hpp"

using namespace slipproof;
using slipproof::test::RandomScenes;

namespace {

ContactState mirrored(ContactState s) {
  if (s == ContactState::slip_forward) return ContactState::slip_backward;
  if (s == ContactState::slip_backward) return ContactState::slip_forward;
  return s;
}

constexpr ContactMode stick_stick{ContactState::stick, ContactState::stick};

}  // namespace

TEST_CASE("a push on the frame has no rear and no front: mirror the bicycle and the force") {
  // No sprocket (I1 = 0) and the arm L = 0: the chain has no part in the motion.
  RandomScenes random(21);
  for (int i = 0; i < 60; ++i) {
    auto p = random.bicycle(true);
    p.I1 = 0;
    p.L = 0;
    auto q = p;
    std::swap(q.b2, q.b3);
    std::swap(q.I2, q.I3);
    const auto road = random.road();
    const ModeTable one(p, road, ForceKind::external), other(q, road, ForceKind::external);
    for (const ModeSolution& s : one.solutions()) {
      const ModeSolution* t = other.find({mirrored(s.mode().front), mirrored(s.mode().rear)});
      REQUIRE(t != nullptr);
      REQUIRE(s.kind() == ModeSolution::Kind::regular);
      const auto negated = [](const std::optional<Rational>& x) {
        return x ? std::optional<Rational>(-*x) : std::nullopt;
      };
      CHECK(s.closed().empty() == t->closed().empty());
      CHECK(s.closed().lower() == negated(t->closed().upper()));
      CHECK(s.closed().upper() == negated(t->closed().lower()));
      const Rational F = random.any();
      CHECK(s.quantity(Quantity::a).at(F) == -t->quantity(Quantity::a).at(Rational(-F)));
      CHECK(s.quantity(Quantity::phi).at(F) == -t->quantity(Quantity::phi).at(Rational(-F)));
      CHECK(s.quantity(Quantity::N2).at(F) == t->quantity(Quantity::N3).at(Rational(-F)));
      CHECK(s.quantity(Quantity::slip2).at(F) == -t->quantity(Quantity::slip3).at(Rational(-F)));
    }
  }
}

TEST_CASE("units do not matter: lengths, masses and times in other units") {
  RandomScenes random(22);
  for (int i = 0; i < 40; ++i) {
    const auto p = random.bicycle(true);
    const auto road = random.road();
    const Rational l = random.positive(), m = random.positive(), t = random.positive();
    const Rational I = m * l * l;
    const Bicycle<Rational> q{p.M * m,  p.R * l,  p.h * l,  p.b2 * l, p.b3 * l, p.I1 * I,
                              p.I2 * I, p.I3 * I, p.r1 * l, p.r2 * l, p.L * l,  Rational(*p.J * I)};
    const ModeTable one(p, road, ForceKind::internal), other(q, {road.f, road.g * l / (t * t)}, ForceKind::internal);
    const Rational newton = m * l / (t * t);
    for (const ModeSolution& s : one.solutions()) {
      const ModeSolution& u = *other.find(s.mode());
      CHECK(s.closed().empty() == u.closed().empty());
      if (s.closed().lower()) CHECK(*s.closed().lower() * newton == *u.closed().lower());
      if (s.closed().upper()) CHECK(*s.closed().upper() * newton == *u.closed().upper());
    }
  }
}

TEST_CASE("f = 0: without friction the forces on the wheels vanish; sticking is at most a boundary motion") {
  RandomScenes random(23);
  for (int i = 0; i < 40; ++i) {
    const auto p = random.bicycle(true);
    const Road<Rational> road{0, random.positive()};
    const ModeTable table(p, road, ForceKind::external);
    const auto found = motions_at(table, random.any());
    for (const auto& motion : found.motions) {
      CHECK(motion.values[Quantity::S2] == 0);
      CHECK(motion.values[Quantity::S3] == 0);
    }
    for (const ModeSolution& s : table.solutions()) {
      if (s.mode().rear == ContactState::stick || s.mode().front == ContactState::stick) CHECK(s.strict().empty());
    }
  }
}

TEST_CASE("a condition that vanishes for every force leaves no strict force") {
  RandomScenes random(26);
  auto p = random.bicycle(true);
  p.L = 0;  // the force does nothing, and without friction sticking needs S = 0, which is there
  const ModeTable table(p, {0, 1}, ForceKind::internal);
  const ModeSolution& s = *table.find(stick_stick);
  CHECK(s.closed() == ForceInterval());
  CHECK(s.strict().empty());
}

TEST_CASE(
    "f very large (remark 3 of section 3): both wheels stick, or the front one slips, or a wheel leaves the road") {
  RandomScenes random(24);
  for (int i = 0; i < 60; ++i) {
    auto p = random.reduced(false);
    if (p.h <= 0) p.h = random.positive();
    const ModeTable table(p, {Rational(1000000000), random.positive()}, ForceKind::internal);
    for (const ModeSolution& s : table.solutions()) {
      ForceInterval forward = s.strict();
      forward.intersect(ForceInterval::open_between(Rational(0), std::nullopt));
      const bool allowed =
          s.mode() == stick_stick || s.mode() == ContactMode{ContactState::stick, ContactState::slip_forward};
      CHECK(forward.empty() != allowed);
    }
  }
}

TEST_CASE("statics (2.8): rest at F = 0 only; an external force also where sigma = 1 and friction suffices") {
  RandomScenes random(25);
  for (int i = 0; i < 60; ++i) {
    auto p = random.bicycle(true);
    if (p.b2 < 0) p.b2 = -p.b2;
    if (p.L == 0) p.L = 1;
    const auto road = random.road();
    const auto rest = [&](ForceKind kind, const Rational& F) {
      const auto m = ModeTable(p, road, kind).find(stick_stick)->motion();
      return m[Quantity::a].at(F) == 0 && m[Quantity::eps2].at(F) == 0 && m[Quantity::eps3].at(F) == 0;
    };
    const Rational F = random.positive();
    for (const ForceKind kind : {ForceKind::internal, ForceKind::external}) {
      CHECK(rest(kind, 0));
      CHECK(rest(kind, F) == (kind == ForceKind::external && sigma(p) == 1));
    }
    p.L = p.R * p.r1 / p.r2;  // sigma = 1: then S2 = F, S3 = 0
    CHECK(rest(ForceKind::external, F));
    CHECK_FALSE(rest(ForceKind::internal, F));
    const ModeTable table(p, road, ForceKind::external);
    CHECK(table.find(stick_stick)->quantity(Quantity::S2) == Affine<Rational>(0, 1));
    CHECK(table.find(stick_stick)->quantity(Quantity::S3) == Affine<Rational>(0, 0));
  }
}
