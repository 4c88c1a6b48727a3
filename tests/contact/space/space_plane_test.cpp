// Maps of scenes in space, and changes along a parameter, against a particle whose motion is worked out by hand.
#include "contact/space/space_plane.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "base/number/format.hpp"
#include "contact/space/solved_text.hpp"
#include "mechanics/reading/read_mechanism.hpp"

using namespace slipproof;

namespace {

/// Of the mass 1, pulled along and up by F each: N = 10 - F.
MechanismScene pulled_particle() {
  const Mechanism mechanism = parse_mechanism(R"(
schema = "slipproof/mechanism/1"
name = "particle"
dimension = 3
gravity = ["0", "0", "-10"]
parameters = { mu = "mu > 0" }
load = { symbol = "F", domain = "F > 1" }
[[body]]
name = "particle"
mass = "1"
turning = ["0", "0", "0"]
spin = ["0", "0", "0"]
at = ["0", "0", "0"]
[[force]]
on = "particle"
at = ["0", "0", "0"]
is = ["F", "0", "F"]
)" + test::standing("p", "particle", R"("0", "0", "0")", "mu"),
                                              "particle.toml");
  MechanismScene scene{"particle", mechanism, default_values(mechanism), Rational(9, 2), {}};
  scene.values.parameters = {Rational(1, 2)};
  return scene;
}

std::string by_hand(const Rational& mu, const Rational& F) {
  return F > 10 ? "lift" : F > mu * (10 - F) ? "slip" : "stick";
}

}  // namespace

TEST_CASE("a map in space has the motions of each place") {
  const MechanismAxes axes{"mu", Rational(0), Rational(1), Rational(0), Rational(12)};
  const PhaseDiagram map = raster_diagram(space_plane(pulled_particle(), axes, "m", effort_of_a_place), 4, 8, {});
  REQUIRE(map.raster);
  REQUIRE(map.raster->places.size() == 32);
  CHECK(map.raster->complete() == 32);
  for (const PhaseRaster::Place& place : map.raster->places) {
    CAPTURE(exact_text(place.x));
    CAPTURE(exact_text(place.y));
    CHECK(place.set.has_value() == (place.y > 1));
    if (place.set) CHECK(name(*place.set) == by_hand(place.x, place.y));
  }
  CHECK(map.plane.words({ElementState::slip_forward}) == "p slips");
  REQUIRE(map.plane.mark);
  CHECK(map.plane.mark->y == Rational(9, 2));
}

TEST_CASE("a place whose search is given up is not complete") {
  const MechanismAxes axes{"mu", Rational(0), Rational(1), Rational(2), Rational(12)};
  const PhaseDiagram map = raster_diagram(space_plane(pulled_particle(), axes, "m", 1), 2, 2, {});
  CHECK(map.raster->complete() == 0);
  for (const PhaseRaster::Place& place : map.raster->places) CHECK(name(*place.set) == "not decided");
}

TEST_CASE("a change along a parameter lies between two values at which all motions are known") {
  const auto along = [](const Rational& from, const Rational& to) {
    return space_along(pulled_particle(), {"mu", from, to, {}, {}}, 3, effort_of_a_place, {});
  };
  const SetsAlong changes = along(Rational(1, 10), 1);
  CHECK(changes.is_complete());
  const auto runs = changes.runs();
  REQUIRE(runs.size() == 2);
  const auto &below = changes.places[runs[0].second], &above = changes.places[runs[1].first];
  CHECK(name(*below.set) == "slip");
  CHECK(name(*above.set) == "stick");
  CHECK(below.x < Rational(9, 11));  // F / (10 - F)
  CHECK(above.x > Rational(9, 11));
  CHECK(above.x - below.x < Rational(1, 3000));
  CHECK(along(Rational(1, 10), Rational(1, 5)).runs().size() == 1);
  const auto outside = along(-1, Rational(1, 5));
  CHECK(!outside.places.front().set);
  CHECK(outside.runs().size() == 2);
}

TEST_CASE("a map in space needs a range of the load, and a problem that has an answer") {
  MechanismScene scene = pulled_particle();
  scene.load.reset();
  CHECK_THROWS_AS(space_plane(scene, {"mu", {}, {}, {}, {}}, "m", 1), std::invalid_argument);
  CHECK_NOTHROW(space_plane(scene, {"mu", {}, {}, Rational(2), Rational(3)}, "m", 1));
}
