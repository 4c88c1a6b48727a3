// Mistakes that a person makes when drawing a scene are told, with their places.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "mechanics/checks/checks.hpp"
#include "mechanics/checks/free_motion.hpp"
#include "mechanics/checks/show.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/write_mechanism.hpp"
#include "program/bad_input/table.hpp"
#include "support/replaced.hpp"

using namespace slipproof;

namespace {

const std::string bad_bodies = SLIPPROOF_SOURCE_DIR "/tests/mechanics/bodies/bad_bodies.toml";

std::string good_bodies() {
  return test::good_input(bad_bodies);
}

using test::replaced;

ElementKind::Start start_of(const Mechanism& mechanism, const std::string& element) {
  for (std::size_t i = 0; i < mechanism.elements(); ++i) {
    if (element_name(mechanism, i) == element) return starts(mechanism)[i];
  }
  FAIL("no such element");
  return {};
}

}  // namespace

TEST_CASE("every mistake in a scene of bodies gets its messages") {
  test::check_bad_inputs(bad_bodies, 60, [](const std::string& text) { parse_mechanism(text, "bad.toml"); });
}

TEST_CASE("states follow from velocities, and what does not hold everywhere becomes a condition") {
  const Mechanism barrow = parse_mechanism(good_bodies(), "barrow.toml");
  CHECK(start_of(barrow, "tyre") == ElementKind::Start::rest);
  CHECK(start_of(barrow, "leg") == ElementKind::Start::slides_forward);
  CHECK(start_of(barrow, "tip") == ElementKind::Start::open);
  CHECK(start_of(barrow, "brake") == ElementKind::Start::slides_forward);
  CHECK(start_of(barrow, "tyre_rolling") == ElementKind::Start::slides_backward);
  CHECK(barrow.assume.empty());  // that v and R are above 0 says it all

  const std::string lifted = replaced(
      replaced(good_bodies(), "velocity = [\"v\", \"0\"]\nshape = { box", "velocity = [\"v\", \"v/2\"]\nshape = { box"),
      "velocity = [\"v\", \"0\"]\nspin", "velocity = [\"v\", \"v/2\"]\nspin");
  const Mechanism flying = parse_mechanism(lifted, "flying.toml");
  CHECK(start_of(flying, "tyre") == ElementKind::Start::open);
  CHECK(start_of(flying, "leg") == ElementKind::Start::open);

  std::string either = replaced(good_bodies(), "v = { domain = \"v > 0\"", "v = { domain = \"real\"");
  either = replaced(either, "friction = { static", "state = \"slides-\"\nfriction = { static");
  either = replaced(either, "limit = \"mu*b*m*g\"\n", "limit = \"mu*b*m*g\"\nstate = \"slides-\"\n");
  either = replaced(either, "rolling_resistance = \"R/100\"\n", "");
  const Mechanism backward = parse_mechanism(either, "backward.toml");
  CHECK(start_of(backward, "leg") == ElementKind::Start::slides_backward);
  CHECK(std::ranges::any_of(backward.assume, [](const MechanismCondition& one) {
    return one.name == "leg-slides" && to_string(one.condition.expression) == "v < 0";
  }));
}

TEST_CASE("a scene may not say another state than the velocities") {
  const Mechanism barrow = parse_mechanism(good_bodies(), "barrow.toml");
  CHECK(check_mechanism(barrow).empty());
  const Mechanism again = parse_mechanism(to_toml(barrow), "again.toml");
  CHECK(start_of(again, "leg") == ElementKind::Start::slides_forward);
}

TEST_CASE("joints that say the same twice are named, and leave their forces open") {
  const Mechanism door = parse_mechanism(R"(
schema = "slipproof/mechanism/1"
name = "trap door on two hinges"
gravity = ["0", "-g"]
[parameters]
g = "g > 0"
[[body]]
name = "door"
mass = "1"
inertia = "1"
[[joint]]
name = "left"
kind = "pin"
between = ["ground", "door"]
at = ["-1", "0"]
[[joint]]
name = "right"
kind = "pin"
between = ["ground", "door"]
at = ["1", "0"]
)",
                                         "door.toml");
  const auto found = mechanism_checks::freedom(door);
  REQUIRE(found);
  CHECK(found->degrees == 0);
  REQUIRE(found->said_before.size() == 1);
  CHECK(door.links[found->said_before[0]].name == "right_x");
  CHECK(show_text(door, {}).find("said by the links before: right_x") != std::string::npos);

  const Mechanism barrow = parse_mechanism(good_bodies(), "barrow.toml");
  CHECK(mechanism_checks::freedom(barrow)->degrees == 4);
  CHECK(mechanism_checks::freedom(barrow)->said_before.empty());
}
