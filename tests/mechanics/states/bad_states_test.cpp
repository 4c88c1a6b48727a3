// Mistakes in [state] and in what joints place are told, with their places; and what [state] can say.
#include <doctest/doctest.h>

#include <string>

#include "mechanics/bodies/bodies.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/states/same_mechanism.hpp"
#include "program/bad_input/table.hpp"
#include "support/replaced.hpp"

using namespace slipproof;
using test::replaced;

namespace {

const std::string bad_states = SLIPPROOF_SOURCE_DIR "/tests/mechanics/states/bad_states.toml";

std::string good_states() {
  return test::good_input(bad_states);
}

Mechanism with_state(const std::string& state) {
  return parse_mechanism(replaced(good_states(), "rail.speed = \"v\"\nhang.rate = \"w\"\n", state), "cart.toml");
}

}  // namespace

TEST_CASE("every mistake in a state gets its messages") {
  test::check_bad_inputs(bad_states, 38, [](const std::string& text) { parse_mechanism(text, "bad.toml"); });
}

TEST_CASE("the same velocities follow from joints, bodies, points and what is given") {
  const Mechanism cart = parse_mechanism(good_states(), "cart.toml");
  const Body& bob = cart.bodies->bodies[2];
  CHECK(test::is_identical(cart, bob.velocity.x.expression, "v + w*l*c"));
  CHECK(test::is_identical(cart, bob.velocity.y.expression, "w*l*s"));
  for (const std::string state : {
           "cart.velocity = [\"v\", \"0\"]\nbob.spin = \"w\"\n",
           "bob.velocity = { at = [\"0\", \"l\"], x = \"v\" }\nbob.spin = \"w\"\n",
           "rail_front.sliding = \"v\"\nhang.rate = \"w\"\n",
           "bob.velocity.x = \"v + w*l*c\"\nbob.spin = \"w\"\n",
           "rail.speed = \"v\"\nbob.spin = \"w\"\ncart.spin = \"0\"\nrail_back.opening = \"0\"\n",
       }) {
    CAPTURE(state);
    test::check_same_mechanism(with_state(state), cart);
  }
  const std::string given = replaced(good_states(), "by = \"hang\"\n", "by = \"hang\"\nspin = \"w\"\n");
  test::check_same_mechanism(parse_mechanism(replaced(given, "hang.rate = \"w\"\n", ""), "cart.toml"), cart);
}

TEST_CASE("in space the freedoms that are left are named, and what a slider with friction needs") {
  const std::string leg = read_text_file(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/linkages/hinge-chain.toml");
  const auto messages = [](const std::string& text) {
    return test::said({"", text, {}, 3}, [](const std::string& one) { parse_mechanism(one, "leg.toml"); });
  };
  const std::string open =
      ": state: 1 freedom is left: the spin of shin about y is not determined, expected one more number";
  const auto said = messages(replaced(leg, "knee.rate = \"q\"\n", ""));
  REQUIRE(said.size() == 1);
  CHECK(said[0].ends_with(open));
  const std::string rail =
      "[[joint]]\nname = \"rail\"\nkind = \"slider\"\nbetween = [\"ground\", \"thigh\"]\n"
      "at = [\"0\", \"0\", \"0\"]\naxis = [\"1\", \"0\", \"0\"]\nfriction = \"1\"\n[[torque]]";
  const auto refused = messages(replaced(leg, "[[torque]]", rail));
  REQUIRE(refused.size() == 3);
  CHECK(refused[0].ends_with("missing length in [[joint]], expected the distance of its two guides"));
  CHECK(refused[1].ends_with(
      "missing normal in [[joint]], expected the normal of the rail, out of the first body, across the axis"));
  CHECK(
      refused[2].ends_with("missing width in [[joint]], expected the distance of the feet on both sides of the rail"));
  const std::string by_vector = replaced(leg, "knee.rate = \"q\"", "shin.spin = [\"-q*s1\", \"q*c1\", \"p\"]");
  test::check_same_mechanism(parse_mechanism(by_vector, "leg.toml"), parse_mechanism(leg, "leg.toml"));
}

TEST_CASE("where a rate leaves the others open at some places, these are left out") {
  const Mechanism cart = with_state("rail.speed = \"v\"\nbob.velocity.x = \"v + w*l*c\"\n");
  bool said = false;
  for (const MechanismCondition& one : cart.assume) {
    said = said || (one.name == "state-is-enough" && to_string(one.condition.expression) == "c != 0");
  }
  CHECK(said);
  const Mechanism everywhere = with_state("rail.speed = \"v\"\nhang.rate = \"w\"\n");
  for (const MechanismCondition& one : everywhere.assume) CHECK(one.name != "state-is-enough");
}

TEST_CASE("a joint places its first body as well as its second, and a contact that rests rolls") {
  const std::string turned = replaced(
      replaced(replaced(good_states(), "between = [\"cart\", \"bob\"]\nat = [\"0\", \"0\"]\nto = [\"0\", \"l\"]\n",
                        "between = [\"bob\", \"cart\"]\nat = [\"0\", \"l\"]\nto = [\"0\", \"0\"]\n"),
               "theta = { cos = \"c\", sin = \"s\" }",
               "theta = { cos = \"c\", sin = \"t\" }\n[definitions]\ns = \"-t\""),
      "hang.rate = \"w\"", "hang.rate = \"-w\"");
  const Mechanism other = parse_mechanism(turned, "cart.toml");
  const Body& bob = other.bodies->bodies[2];
  CHECK(test::is_identical(other, bob.velocity.x.expression, "v + w*l*c"));
  CHECK(test::is_identical(other, bob.velocity.y.expression, "w*l*s"));
  CHECK(test::is_identical(other, bob.at.x.expression, "x + l*s"));

  const Mechanism wheel = parse_mechanism(R"(
schema = "slipproof/mechanism/1"
name = "barrow"
gravity = ["0", "-g"]
[parameters]
g = "g > 0"
v = "v > 0"
[[body]]
name = "frame"
mass = "1"
inertia = "1"
at = ["0", "1"]
[[body]]
name = "wheel"
mass = "1"
inertia = "1"
at = ["2", "1/2"]
[[joint]]
name = "axle"
kind = "pin"
between = ["frame", "wheel"]
at = ["2", "-1/2"]
to = ["0", "0"]
[[contact]]
name = "tyre"
of = "wheel"
point = ["0", "0"]
radius = "1/2"
normal = ["0", "1"]
friction = "1"
state = "rest"
[state]
frame.velocity = ["v", "0"]
frame.spin = "0"
)",
                                          "barrow.toml");
  CHECK(to_string(wheel.bodies->bodies[2].spin.z.expression) == "-2 * v");
}

TEST_CASE("a pin with friction is a disc in a ring") {
  const std::string text = good_states();
  const std::size_t joint = text.find("[[joint]]\nname = \"nail\""), state = text.find("[state]");
  std::string at_length = text;
  at_length.replace(joint, state - joint, R"([[contact]]
name = "nail"
of = "board"
point = ["0", "l"]
radius = "r"
on_point = ["0", "6*l"]
on_radius = "-11*r/10"
friction = "mu"
)");
  const Mechanism one = parse_mechanism(text, "cart.toml"), other = parse_mechanism(at_length, "cart.toml");
  REQUIRE(one.contacts.size() == 3);
  CHECK(one.contacts[2].name == "nail");
  CHECK(!one.contacts[2].bilateral);
  CHECK(to_string(one.contacts[2].gap.expression) == to_string(other.contacts[0].gap.expression));
  CHECK(to_string(one.contacts[2].slip.expression) == to_string(other.contacts[0].slip.expression));
}
