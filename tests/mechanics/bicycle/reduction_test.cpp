#include "mechanics/bicycle/reduction.hpp"

#include <doctest/doctest.h>

#include "mechanics/bicycle/conditions.hpp"
#include "mechanics/bicycle_modes/mode_table.hpp"
#include "support/random_scene.hpp"
#include "support/raw_solver.hpp"
#include "support/unknowns.hpp"

using namespace slipproof;
using slipproof::test::RandomScenes;

namespace {

constexpr std::array kinds{ForceKind::internal, ForceKind::external};

/// Five residuals of (2.6) as printed; for an external force with the two further terms of the text after (2.7).
std::array<Rational, 5> equations_2_6(const Bicycle<Rational>& p, const Road<Rational>& road, ForceKind kind,
                                      const Rational& F, const Motion<Rational>& m) {
  const Rational mu = p.r2 / p.r1, s = mu * p.L / p.R;
  const Rational I0 = p.I1 * mu * mu + p.I2, k1 = p.I1 * mu * (mu - 1) / I0, k2 = (p.I1 * mu + p.I2) / I0;
  const Rational tangential = m[Quantity::S2] + m[Quantity::S3];
  Rational along = tangential;
  Rational pitch = m[Quantity::N3] * p.b3 - m[Quantity::N2] * p.b2 + tangential * p.h + F * s * p.R * k2 +
                   m[Quantity::S2] * p.R * k1;
  if (kind == ForceKind::external) {
    along -= F;
    pitch -= F * (p.L + p.h);
  }
  return {m[Quantity::a] - along, I0 * m[Quantity::eps2] / p.R - F * s + m[Quantity::S2],
          p.I3 * m[Quantity::eps3] / p.R + m[Quantity::S3], m[Quantity::N2] + m[Quantity::N3] - road.g, pitch};
}

}  // namespace

TEST_CASE("the reduction agrees with the raw equations in every mode, exactly") {
  RandomScenes random(1);
  for (int i = 0; i < 40; ++i) {
    const auto p = random.bicycle(true);
    const auto road = random.road();
    for (const ForceKind kind : kinds) {
      const ModeTable table(p, road, kind);
      REQUIRE(table.solutions().size() == 16);
      for (const ModeSolution& s : table.solutions()) {
        const auto raw = test::solve_raw(p, road, kind, s.mode());
        CHECK((s.kind() == ModeSolution::Kind::regular) == raw.has_value());
        if (raw && s.kind() == ModeSolution::Kind::regular) CHECK(s.motion() == *raw);
      }
    }
  }
}

TEST_CASE("conditions of the reduction are those of the table of contact states") {
  RandomScenes random(2);
  for (int i = 0; i < 40; ++i) {
    const auto p = random.bicycle(true);
    const auto road = random.road();
    const ModeTable table(p, road, ForceKind::external);
    for (const ModeSolution& s : table.solutions()) {
      if (s.kind() != ModeSolution::Kind::regular) continue;
      const auto motion = s.motion();
      for (const Condition& c : conditions(s.mode())) CHECK(s.condition_value(c) == condition_value(c, motion, road.f));
    }
  }
}

TEST_CASE("every motion satisfies the raw equations at a force") {
  RandomScenes random(3);
  for (int i = 0; i < 40; ++i) {
    const auto p = random.bicycle(true);
    const auto road = random.road();
    for (const ForceKind kind : kinds) {
      const Rational F = random.any();
      const ModeTable table(p, road, kind);
      for (const ModeSolution& s : table.solutions()) {
        if (s.kind() != ModeSolution::Kind::regular) continue;
        Motion<Rational> m;
        for (const Quantity q : all_quantities()) m[q] = s.quantity(q).at(F);
        const auto u = test::unknowns(p, F, m);
        for (const Rational& residual : equations_of_motion(p, road, kind, u, F)) CHECK(residual == 0);
        for (const Wheel w : {Wheel::rear, Wheel::front}) {
          for (const Rational& residual : contact_equations(p, road, u, w, s.mode()[w])) CHECK(residual == 0);
        }
        CHECK(m == motion_of(p, u));
      }
    }
  }
}

TEST_CASE("with both wheels on the road the equations reduce to (2.6), internal and external, any mu") {
  // Both systems leave S2 and S3 free and determine all else, so one inclusion is equality.
  RandomScenes random(4);
  for (int i = 0; i < 100; ++i) {
    auto p = random.bicycle(i % 2 == 0);  // J drops out
    p.M = 1;
    const auto road = random.road();
    for (const ForceKind kind : kinds) {
      const Rational F = random.any(), S2 = random.any(), S3 = random.any();
      auto system = raw_system(p, road, kind, {ContactState::stick, ContactState::stick});
      system[8] = LinearForm<Rational>::variable(7) - LinearForm<Rational>(S2);   // instead of slip2 = 0
      system[10] = LinearForm<Rational>::variable(8) - LinearForm<Rational>(S3);  // instead of slip3 = 0
      test::RationalMatrix A(11, 11), b(11, 1);
      for (int r = 0; r < 11; ++r) {
        const auto& form = system[static_cast<std::size_t>(r)];
        for (int c = 0; c < 11; ++c) A(r, c) = form.coefficients[static_cast<std::size_t>(c)];
        b(r, 0) = -form.constant - form.coefficients[11] * F;
      }
      Eigen::FullPivLU<test::RationalMatrix> lu(A);
      lu.setThreshold(Rational(0));
      REQUIRE(lu.rank() == 11);
      const test::RationalMatrix x = lu.solve(b);
      CHECK(x(1, 0) == 0);
      CHECK(x(2, 0) == 0);
      Motion<Rational> m;
      m[Quantity::a] = x(0, 0);
      m[Quantity::eps2] = x(4, 0);
      m[Quantity::eps3] = x(5, 0);
      m[Quantity::S2] = x(7, 0);
      m[Quantity::S3] = x(8, 0);
      m[Quantity::N2] = x(9, 0);
      m[Quantity::N3] = x(10, 0);
      for (const Rational& residual : equations_2_6(p, road, kind, F, m)) CHECK(residual == 0);
    }
  }
}

TEST_CASE("Problems 1 and 2: accelerations (1.4) and (1.5) without slip, for any mu and b2 != b3") {
  RandomScenes random(5);
  for (int i = 0; i < 200; ++i) {
    auto p = random.bicycle(false);
    p.M = 1;
    const auto road = random.road();
    const Rational mu = p.r2 / p.r1;
    const Rational M0 = 1 + (p.I1 * mu * mu + p.I2 + p.I3) / (p.R * p.R);
    const Rational s = sigma(p);
    const auto acceleration = [&](ForceKind kind) {
      const ModeTable table(p, road, kind);
      return table.find({ContactState::stick, ContactState::stick})->quantity(Quantity::a);
    };
    CHECK(acceleration(ForceKind::internal) == Affine<Rational>(0, s / M0));
    CHECK(acceleration(ForceKind::external) == Affine<Rational>(0, -(1 - s) / M0));
  }
}
