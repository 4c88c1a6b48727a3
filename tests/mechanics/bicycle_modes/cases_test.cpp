// The shipped scenes show what their comments promise.
#include <doctest/doctest.h>

#include <set>
#include <string>

#include "mechanics/bicycle/scene.hpp"
#include "mechanics/bicycle_modes/motions.hpp"

using namespace slipproof;

namespace {

Scene shipped(const std::string& name) {
  return read_scene(SLIPPROOF_SOURCE_DIR "/cases/" + name + ".toml");
}

/// The modes of all motions at the scene's force.
std::set<std::string> modes_of(const Scene& scene) {
  const ModeTable table(scene.bicycle, scene.road, scene.force_kind);
  const MotionsAtForce found = motions_at(table, *scene.F);
  std::set<std::string> result;
  for (const auto& motion : found.motions) {
    for (const auto mode : motion.modes) result.insert(name(mode));
  }
  return result;
}

/// sign of the acceleration of the one motion.
int direction(const Scene& scene) {
  const ModeTable table(scene.bicycle, scene.road, scene.force_kind);
  const MotionsAtForce found = motions_at(table, *scene.F);
  REQUIRE(found.motions.size() == 1);
  return sign(found.motions[0].values[Quantity::a]);
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
  CHECK(shipped("low-recumbent").bicycle.h < 0);
  const auto penny = shipped("penny-farthing").bicycle;
  CHECK(penny.h + penny.R > (penny.b2 + penny.b3) * Rational(3, 2));
}

TEST_CASE("Problem 2: with the force for sigma < 1, against it for sigma > 1, at rest for sigma = 1") {
  struct Side {
    const char* file;
    int sigma_side;  // sign of sigma - 1
    int a_sign;
  };
  for (const Side& side :
       {Side{"pulled-pedal", -1, -1}, Side{"pulled-pedal-low-gear", 1, 1}, Side{"pulled-pedal-balanced", 0, 0}}) {
    const Scene scene = shipped(side.file);
    CAPTURE(side.file);
    CHECK(scene.force_kind == ForceKind::external);
    CHECK(sign(Rational(sigma(scene.bicycle) - 1)) == side.sigma_side);
    CHECK(modes_of(scene) == Modes{"stick/stick"});
    CHECK(direction(scene) == side.a_sign);
  }
}

TEST_CASE("the ambiguous scene has more than one motion with both wheels on the road") {
  const Modes modes = modes_of(shipped("ambiguous"));
  CHECK(modes.contains("stick/stick"));
  CHECK(modes.contains("stick/slip+"));
}
