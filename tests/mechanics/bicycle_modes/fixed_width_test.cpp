// Modes solved in integers of fixed width, and in those of any size where the width may not do: the same motions.
#include <doctest/doctest.h>

#include "mechanics/bicycle/conditions.hpp"
#include "mechanics/bicycle_modes/motions.hpp"
#include "support/random_scene.hpp"
#include "support/raw_solver.hpp"

using namespace slipproof;
using slipproof::test::RandomScenes;

namespace {

/// A scene with numbers near 2^bits over 2^bits + 1, or next to it: their products are as long as they can be.
struct LongScene {
  Bicycle<Rational> bicycle;
  Road<Rational> road;

  LongScene(RandomScenes& random, std::size_t bits) : bicycle(random.bicycle(true)), road(random.road()) {
    const auto lengthen = [&](Rational& x) {
      const Integer power = Integer(1) << bits;
      x *= Rational(power - Integer(random.integer(0, 1)), power + Integer(random.integer(0, 1)));
    };
    Bicycle<Rational>& p = bicycle;
    for (Rational* x : {&p.M, &p.I1, &p.I2, &p.I3, &p.r1, &p.r2, &p.L, &*p.J, &road.f, &road.g}) lengthen(*x);
  }
};

/// The longest number that the formulas give, in integers of any size.
std::size_t longest_number(const LongScene& scene, ForceKind kind) {
  const IntegerScene s = to_integers(scene.bicycle, scene.road);
  const auto dynamics =
      reduce<Integer, Affine<Integer>>(s.bicycle, s.road, kind, {Integer(0), s.force}, s.friction_denominator);
  std::size_t longest = 0;
  for (const ContactMode mode : all_modes()) {
    const ReducedMotion<Integer, Affine<Integer>> motion(dynamics, mode);
    for (const Quantity q : all_quantities()) {
      const auto x = motion.quantity(q);
      for (const Integer* number : {&x.numerator.alpha, &x.numerator.beta, &x.denominator}) {
        longest = std::max(longest, number->bits());
      }
    }
  }
  return longest;
}

void check_table(const LongScene& scene, ForceKind kind) {
  const ModeTable table(scene.bicycle, scene.road, kind);
  for (const ModeSolution& s : table.solutions()) {
    const auto raw = test::solve_raw(scene.bicycle, scene.road, kind, s.mode());
    REQUIRE(raw.has_value() == (s.kind() == ModeSolution::Kind::regular));
    if (!raw) continue;
    CHECK(s.motion() == *raw);
    for (const Quantity q : all_quantities()) CHECK(s.quantity(q) == (*raw)[q]);
    ForceInterval closed;
    for (const Condition& c : conditions(s.mode())) {
      const Affine<Rational> value = condition_value(c, *raw, scene.road.f);
      closed.restrict_to(value, false);
      CHECK(s.condition_value(c).at(Rational(2)).sign() == value.at(Rational(2)).sign());
    }
    CHECK(s.closed() == closed);
  }
}

}  // namespace

TEST_CASE("modes of numbers of every length, on both sides of the width: Eigen's motions of the raw equations") {
  RandomScenes random(71);
  int within = 0, near = 0, beyond = 0;
  for (std::size_t bits = 1; bits < 48; ++bits) {
    for (const ForceKind kind : {ForceKind::internal, ForceKind::external}) {
      const LongScene scene(random, bits);
      const std::size_t longest = longest_number(scene, kind);
      ++(longest > ModeInteger::value_bits ? beyond : longest + 40 > ModeInteger::value_bits ? near : within);
      check_table(scene, kind);
    }
  }
  CHECK(within > 3);
  CHECK(near > 3);
  CHECK(beyond > 20);
}
