// Scenes of many contacts: what statics says by hand.
#include <doctest/doctest.h>

#include "mechanics/kernel/kinematic_modes.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/scene.hpp"

using namespace slipproof;

namespace {

struct Many {
  MechanismScene scene;
  FrictionProblem problem;

  explicit Many(const std::string& name)
      : scene(read_scene(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/many/scenes/" + name + ".toml")),
        problem(friction_problem(scene.mechanism, scene.values)) {}

  /// The one motion at a load.
  std::vector<Rational> at(const Rational& load) const {
    const MotionsAtLoad found = motions_of(problem, load);
    CHECK(found.by_kinematics);
    CHECK(found.continua.empty());
    REQUIRE(found.motions.size() == 1);
    return found.motions[0].accelerations;
  }
};

}  // namespace

TEST_CASE("a beam on 24 feet slides at mu W, and tips where friction and push turn it about its last foot") {
  const Many beam("beam-on-24-feet");
  CHECK(beam.at(59)[0] == 0);
  CHECK(beam.at(72)[0] == 1);
  CHECK(beam.at(72)[2] == 0);
  CHECK(beam.at(359)[2] == 0);
  CHECK(beam.at(361)[2] < 0);
}

TEST_CASE("of ten blocks the topmost slides, and the tower stands") {
  const Many blocks("ten-blocks");
  const auto rest = blocks.at(Rational(49, 10)), slides = blocks.at(6);
  for (std::size_t i = 0; i < blocks.scene.mechanism.accelerations; ++i) CHECK(rest[i].is_zero());
  CHECK(slides[27] == 1);  // of the tenth block along x: 6 - 5 over 1
  for (std::size_t i = 0; i < 27; ++i) CHECK(slides[i].is_zero());
}

TEST_CASE("twelve fingertips hold a ball, and jam it where the most oblique reach above their own normals") {
  // A finger with the normal (12, 5) / 13 pulls down as hard as it pushes up at mu = 5/12.
  Many hand("hand-of-12-fingers");
  const auto motions = [&](const Rational& mu, const Rational& load) {
    hand.scene.values.parameters[0] = mu;
    return motions_of(friction_problem(hand.scene.mechanism, hand.scene.values), load).motions;
  };
  CHECK(motions(Rational(1, 2), 8).size() == 1);
  CHECK(motions(Rational(1, 2), 12).size() == 2);
  CHECK(motions(Rational(5, 12) + Rational(1, 1000), 12).size() == 2);
  const auto lifts = motions(Rational(5, 12) - Rational(1, 1000), 12);
  REQUIRE(lifts.size() == 1);
  CHECK(lifts[0].accelerations[1] == 2);
  CHECK(motions(Rational(5, 12) - Rational(1, 1000), 8)[0].accelerations[1] == 0);
}
