#include "mechanics/bicycle_modes/delassus.hpp"

#include <doctest/doctest.h>

#include "mechanics/bicycle_modes/mode_table.hpp"
#include "support/random_scene.hpp"

using namespace slipproof;

TEST_CASE("the Delassus form gives the contact accelerations of every motion, and W is symmetric") {
  test::RandomScenes random(41);
  for (int i = 0; i < 60; ++i) {
    const auto p = random.bicycle(true);
    const auto road = random.road();
    const ForceKind kind = i % 2 == 0 ? ForceKind::internal : ForceKind::external;
    const auto form = delassus(p, road, kind);
    REQUIRE(form);
    for (std::size_t r = 0; r < 4; ++r) {
      CHECK(form->W[r][r] > 0);
      for (std::size_t c = 0; c < r; ++c) {
        // slip is the acceleration along x, S the force along x; gap points up, N acts up: both pairs do work.
        CHECK(form->W[r][c] == form->W[c][r]);
      }
    }
    const ModeTable table(p, road, kind);
    const Rational F = random.any();
    for (const ModeSolution& s : table.solutions()) {
      if (s.kind() != ModeSolution::Kind::regular) continue;
      const auto at = [&](Quantity q) { return s.quantity(q).at(F); };
      const std::array<Rational, 4> forces{at(Quantity::N2), at(Quantity::S2), at(Quantity::N3), at(Quantity::S3)};
      const std::array<Rational, 4> accelerations{at(Quantity::gap2), at(Quantity::slip2), at(Quantity::gap3),
                                                  at(Quantity::slip3)};
      for (std::size_t r = 0; r < 4; ++r) {
        Rational value = form->free[r] + form->per_force[r] * F;
        for (std::size_t c = 0; c < 4; ++c) value += form->W[r][c] * forces[c];
        CHECK(value == accelerations[r]);
      }
    }
  }
}

TEST_CASE("no Delassus form without J, nor with a wheel that has no inertia") {
  test::RandomScenes random(42);
  auto p = random.bicycle(true);
  const auto road = random.road();
  p.I3 = 0;
  CHECK_FALSE(delassus(p, road, ForceKind::internal));
  CHECK_FALSE(delassus(random.bicycle(false), road, ForceKind::internal));
}
