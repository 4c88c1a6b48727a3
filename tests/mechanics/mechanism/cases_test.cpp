// The shipped scenes show what their comments promise.
#include <doctest/doctest.h>

#include <set>
#include <string>

#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/bicycle_scene.hpp"

using namespace slipproof;

namespace {

MechanismScene shipped(const std::string& name) {
  return read_scene(SLIPPROOF_SOURCE_DIR "/cases/" + name + ".toml");
}

MotionsAtLoad motions_of(const MechanismScene& scene) {
  return slipproof::motions_of(friction_problem(scene.mechanism, scene.values), scene.load);
}

/// The modes of all motions at the scene's force.
std::set<std::string> modes_of(const MechanismScene& scene) {
  std::set<std::string> result;
  for (const MotionAtLoad& motion : motions_of(scene).motions) {
    for (const MechanismMode& mode : motion.all_modes()) result.insert(name(mode));
  }
  return result;
}

/// sign of the acceleration of the one motion.
int direction(const MechanismScene& scene) {
  const MotionsAtLoad found = motions_of(scene);
  REQUIRE(found.motions.size() == 1);
  REQUIRE(acceleration_names(scene.mechanism).front() == "a");
  return sign(found.motions[0].accelerations.front());
}

Rational parameter_of(const MechanismScene& scene, std::string_view symbol) {
  return scene.values.parameters[bicycle_parameter(symbol)];
}

using Modes = std::set<std::string>;

}  // namespace

TEST_CASE("asphalt holds, ice does not, and a pull at the handlebar lifts the front wheel") {
  CHECK(modes_of(shipped("city-bicycle")) == Modes{"stick/stick"});
  CHECK(modes_of(shipped("city-bicycle-on-ice")) == Modes{"slip-/stick"});
  CHECK(modes_of(shipped("motorcycle")) == Modes{"stick/stick"});
  CHECK(modes_of(shipped("wheelie")) == Modes{"stick/lift"});
}

TEST_CASE("the low recumbent is low, the penny-farthing high") {
  CHECK(parameter_of(shipped("low-recumbent"), "h") < 0);
  const MechanismScene penny = shipped("penny-farthing");
  CHECK(parameter_of(penny, "h") + parameter_of(penny, "R") >
        (parameter_of(penny, "b2") + parameter_of(penny, "b3")) * Rational(3, 2));
}

TEST_CASE("Problem 2: with the force for sigma < 1, against it for sigma > 1, at rest for sigma = 1") {
  struct Side {
    const char* file;
    int sigma_side;  // sign of sigma - 1
    int a_sign;
  };
  for (const Side& side :
       {Side{"pulled-pedal", -1, -1}, Side{"pulled-pedal-low-gear", 1, 1}, Side{"pulled-pedal-balanced", 0, 0}}) {
    const MechanismScene scene = shipped(side.file);
    CAPTURE(side.file);
    CHECK(parameter_of(scene, "external") == 1);
    const Rational sigma =
        parameter_of(scene, "r2") * parameter_of(scene, "L") / (parameter_of(scene, "r1") * parameter_of(scene, "R"));
    CHECK(sign(Rational(sigma - 1)) == side.sigma_side);
    CHECK(modes_of(scene) == Modes{"stick/stick"});
    CHECK(direction(scene) == side.a_sign);
  }
}

TEST_CASE("the ambiguous scene has more than one motion with both wheels on the road") {
  const Modes modes = modes_of(shipped("ambiguous"));
  CHECK(modes.contains("stick/stick"));
  CHECK(modes.contains("stick/slip+"));
}
