// What starts open moves by its actual distance: gaps and slips of slack ropes, discs apart and discs in rings, by
// hand. apart.py compares random ones with a computer algebra system.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "mechanics/kernel/motions.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/scene/scene.hpp"
#include "support/replaced.hpp"

using namespace slipproof;
using test::replaced;

namespace apart_test {

namespace {

/// Falls with 10 and flies to the right with 2, turning with 3.
const std::string ball = R"(schema = "slipproof/mechanism/1"
name = "what flies"
gravity = ["0", "-10"]
[[body]]
name = "ball"
mass = "1"
inertia = "1"
at = ["0", "HEIGHT"]
velocity = ["2", "0"]
spin = "3"
)";
std::string slack_rope() {
  return replaced(ball, "HEIGHT", "0") + R"([[joint]]
name = "e"
kind = "rope"
between = ["ball", "ground"]
at = ["0", "0"]
to = ["0", "1"]
length = "2"
state = "slack"
)";
}
std::string disc(const std::string& height, const std::string& on_radius) {
  return replaced(replaced(ball + R"([[contact]]
name = "e"
of = "ball"
point = ["0", "0"]
radius = "1"
on_point = ["0", "0"]
on_radius = "INSIDE"
friction = "1/2"
state = "open"
)",
                           "HEIGHT", height),
                  "INSIDE", on_radius);
}

Rational acceleration(const std::string& text, const std::string& name) {
  const MechanismScene scene = parse_scene(text, "scene.toml");
  const auto names = acceleration_names(scene.mechanism);
  const auto found = std::ranges::find(names, name);
  REQUIRE(found != names.end());
  const MotionsAtLoad motions = motions_of(friction_problem(scene.mechanism, scene.values), std::nullopt);
  REQUIRE(motions.motions.size() == 1);
  return motions.motions.front().accelerations[static_cast<std::size_t>(found - names.begin())];
}

}  // namespace

TEST_CASE("the gap of what starts open is the second derivative of its distance") {
  // With a distance d below the end of the rope: d'' = 10 + 2^2/1, whatever the length of the rope is.
  const std::string rope = slack_rope();
  CHECK(acceleration(rope, "gap_e") == -14);
  CHECK(acceleration(replaced(rope, "length = \"2\"", "length = \"7/3\""), "gap_e") == -14);
  // With centres 3 apart: d'' = -10 + 2^2/3, for all radii.
  const std::string apart = disc("3", "1");
  CHECK(acceleration(apart, "gap_e") == Rational(-26, 3));
  CHECK(acceleration(replaced(apart, "radius = \"1\"\n", ""), "gap_e") == Rational(-26, 3));
  // In a ring, below its centre: the distance of the centres has 10 + 2^2/1, and the gap the opposite.
  const std::string ring = disc("-1", "-3");
  CHECK(acceleration(ring, "gap_e") == -14);
  CHECK(acceleration(replaced(ring, "\"-3\"", "\"-5\""), "gap_e") == -14);
}

TEST_CASE("the slip of what starts open has its direction turn by its distance") {
  // Centres 3 apart, one rising with 1: the sliding 2 has the derivative -2*1/3.
  const std::string rising = replaced(disc("3", "1"), "[\"2\", \"0\"]", "[\"2\", \"1\"]");
  CHECK(acceleration(rising, "slip_e") == Rational(-2, 3));
}

TEST_CASE("distances are expressions where they are rational") {
  const std::string inclined = replaced(replaced(slack_rope(), "[[body]]", R"([parameters]
l = "l > 0 and l < 2"
x = "x < 3 and x > -3 and x != 0"
[angles]
theta = { cos = "c", sin = "s" }
[[body]])"),
                                        "length = \"2\"", "length = \"l + 3\"");
  const auto conditions = [&](const std::string& to) {
    std::string all;
    for (const MechanismCondition& one : parse_mechanism(replaced(inclined, "[\"0\", \"1\"]", to), "m.toml").assume) {
      all += one.name + ": " + to_string(one.condition.expression) + "; ";
    }
    return all;
  };
  CHECK(conditions("[\"l*c\", \"l*s\"]") == "e-is-slack: l + 3 - l >= 0; ");
  CHECK(conditions("[\"3*l/5\", \"-4*l/5\"]") == "e-is-slack: l + 3 - l >= 0; ");
  CHECK(conditions("[\"x\", \"0\"]") == "e-is-apart: abs(x) > 0; e-is-slack: l + 3 - abs(x) >= 0; ");
  CHECK(conditions("[\"(x + l*c/10)*s\", \"(x + l*c/10)*c\"]").starts_with("e-is-apart: abs("));
  CHECK_THROWS_AS(conditions("[\"x\", \"l\"]"), InputError);
}

}  // namespace apart_test
