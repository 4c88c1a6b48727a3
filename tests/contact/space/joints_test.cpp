// Armatures and friction of joints in space: scenes whose motion is worked out by hand.
#include <doctest/doctest.h>

#include <string>

#include "contact/space/motion_value.hpp"
#include "contact/space/solved_text.hpp"

using namespace slipproof;
using test::contains;
using test::is;

namespace {

std::string body(const std::string& name, const std::string& more) {
  return "[[body]]\nname = \"" + name + "\"\nmass = \"2\"\ninertia = [\"3\", \"3\", \"3\"]\n" + more;
}
std::string force(const std::string& on, const std::string& at, const std::string& is) {
  return "[[force]]\non = \"" + on + "\"\nat = [" + at + "]\nis = [" + is + "]\n";
}

/// A carriage of the mass 2 with feet 2 apart along its rail, 1 below its centre of mass, at rest.
std::string carriage(const std::string& velocity, const std::string& push) {
  return body("carriage", "at = [\"0\", \"0\", \"1\"]\nvelocity = [\"" + velocity + "\", \"0\", \"0\"]\n") + R"(
[[joint]]
name = "rail"
kind = "slider"
between = ["ground", "carriage"]
at = ["0", "0", "0"]
to = ["0", "0", "-1"]
axis = ["1", "0", "0"]
normal = ["0", "0", "1"]
length = "2"
width = "1"
friction = "1/2"
)" + push;
}

/// A shaft of the radius 1 in two rings, 2 apart, at whose lowest place it lies, turning about y.
std::string shaft(const std::string& spin) {
  return body("shaft", "at = [\"0\", \"0\", \"-1\"]\nspin = [\"0\", \"" + spin + "\", \"0\"]\n") + R"(
[[joint]]
name = "bearing"
kind = "hinge"
between = ["ground", "shaft"]
at = ["0", "0", "0"]
to = ["0", "0", "0"]
axis = ["0", "1", "0"]
radius = "1"
ring = "2"
length = "2"
friction = "1/2"
)" + force("shaft", "\"0\", \"1/2\", \"0\"", "\"0\", \"0\", \"-4\"");
}

}  // namespace

/// A drum of the inertia 3 and a motor's rotor of the armature 5: 16 = (3 + 5) alpha, and the axle bears the couple 10
/// on the ground. On a carriage that slides, with the mass 2 and the armature 6, 8 = (2 + 6) a, and no weight of the
/// rotor.
TEST_CASE("an armature takes its part of a couple and of a force") {
  const SolvedSpace drum = test::solved_text(body("drum", "") + R"(
[[joint]]
name = "axle"
kind = "hinge"
between = ["ground", "drum"]
at = ["0", "0", "0"]
axis = ["0", "0", "1"]
armature = "5"
[[torque]]
on = "drum"
is = ["0", "0", "16"]
)");
  CHECK(is(drum, "alphaz", 2));
  const SolvedSpace lift = test::solved_text(body("cage", "") + R"(
[[joint]]
name = "shaft"
kind = "slider"
between = ["ground", "cage"]
at = ["0", "0", "0"]
axis = ["0", "0", "1"]
armature = "6"
)" + force("cage", "\"0\", \"0\", \"0\"", "\"0\", \"0\", \"28\""));
  CHECK(is(lift, "az", 1));  // (28 - 20)/(2 + 6)
}

/// Two bodies in free space around one axis, the first with a motor: its rotor of the armature a sees the difference of
/// their turnings only. 3 x + a (x - y) = 0 for what is not driven, 3 y + a (y - x) = 9 for what is.
TEST_CASE("an armature between two bodies that move turns both") {
  const SolvedSpace pair = test::solved_text(body("a", "") + body("b", "") + R"(
[[joint]]
name = "motor"
kind = "hinge"
between = ["a", "b"]
at = ["0", "0", "0"]
axis = ["1", "0", "0"]
armature = "3"
[[torque]]
on = "b"
is = ["9", "0", "0"]
)");
  CHECK(is(pair, "alphax_a", 1));
  CHECK(is(pair, "alphax_b", 2));
}

TEST_CASE("a carriage on a rail sticks, slides and lifts its rear feet") {
  const auto pulled = [](const std::string& height, const std::string& pull) {
    return force("carriage", "\"0\", \"0\", \"" + height + "\"", "\"" + pull + "\", \"0\", \"0\"");
  };
  CHECK(is(test::solved_text(carriage("0", pulled("-1", "9"))), "ax", 0));         // below mu m g = 10
  CHECK(contains(test::solved_text(carriage("0", pulled("-1", "14"))), "ax", 2));  // (14 - 10)/2
  CHECK(is(test::solved_text(carriage("3", pulled("-1", "14"))), "ax", 2));
  CHECK(is(test::solved_text(carriage("-3", pulled("-1", "4"))), "ax", 7));
  const std::string across = force("carriage", "\"0\", \"0\", \"-1\"", "\"0\", \"50\", \"0\"");
  CHECK(is(test::solved_text(carriage("0", across)), "ay", 0));  // its sides are held
  // Pulled 4 above the rail with 8, it tips about its front feet: (3 + 2*(1 + 1)) alpha = 8*4 - 20*1.
  const SolvedSpace tips = test::solved_text(carriage("0", pulled("3", "8")));
  CHECK(is(tips, "alphay", Rational(12, 7)));
  CHECK(tips.motions.front().modes[0] == "stick");
  CHECK(tips.motions.front().modes[2] == "lift");
  CHECK(tips.motions.front().modes[3] == "lift");
}

/// N = (20 + 4)/2 on average, 4 (1/2 + 1)/2 more in front; friction mu N r brakes the shaft and carries it up its
/// rings.
TEST_CASE("a shaft that turns in its rings is braked by mu N r") {
  const SolvedSpace turns = test::solved_text(shaft("6"));
  CHECK(is(turns, "N_bearing_front", 13));
  CHECK(is(turns, "N_bearing_back", 11));
  CHECK(is(turns, "alphay", -4));  // -(1/2) 24 1/3
  CHECK(is(turns, "ay", 0));
  CHECK(is(turns, "az", 0));
  const SolvedSpace rests = test::solved_text(shaft("0"));
  CHECK(is(rests, "alphay", 0));
  CHECK(is(rests, "N_bearing_front", 13));
}
