// What is refused in space, each with its message, and what links leave open.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "base/input/diagnostic.hpp"
#include "contact/space/solved_text.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "support/replaced.hpp"

using namespace slipproof;
using test::replaced;

namespace {

const std::string cube = R"(
[[body]]
name = "block"
mass = "1"
inertia = ["1", "1", "1"]
at = ["0", "0", "1"]
)";

const std::string on_a_foot = test::standing("foot", "block", R"("0", "0", "-1")", "1/2");

std::string joined(const std::string& name, const std::string& kind, const std::string& on, const std::string& rest) {
  return "\n[[joint]]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\nbetween = [\"" + on + "\", \"block\"]\n" +
         rest + "\n";
}

std::string refusal_in_space(const std::string& bodies) {
  try {
    test::solved_text(bodies);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}
bool is_refused(const std::string& bodies, const std::string& because) {
  const std::string found = refusal_in_space(bodies);
  CAPTURE(found);
  const bool said = found.find(because) != std::string::npos;
  CHECK(said);
  return said;
}

}  // namespace

TEST_CASE("mistakes in bodies in space are told") {
  CHECK(refusal_in_space(cube + on_a_foot) == "accepted");
  CHECK(is_refused(cube + "turn = [\"0\", \"0\", \"0\", \"0\"]\n" + on_a_foot, "quaternion of length 0"));
  CHECK(is_refused(cube + "turn = [\"1\", \"0\", \"0\"]\n" + on_a_foot, "turn: expected a quaternion w x y z"));
  CHECK(is_refused(replaced(cube, R"(["1", "1", "1"])", R"("1")") + on_a_foot,
                   "inertia: expected three numbers xx yy zz"));
  CHECK(is_refused(replaced(cube, R"("1", "1", "1")", R"("1", "1", "3")") + on_a_foot,
                   "found the moment of inertia zz larger than the other two together"));
  CHECK(is_refused(replaced(cube, R"("1", "1", "1")", R"("1", "1", "1", "9/10", "0", "0")") + on_a_foot,
                   "products of inertia that are too large"));
  CHECK(is_refused(replaced(cube, R"("0", "0", "1")", R"("0", "1")") + on_a_foot, "at: expected three coordinates"));
  CHECK(is_refused(cube + "velocity = [\"0\", \"0\", \"-1\"]\n" + on_a_foot,
                   "approach the surface with the velocity -1"));
  CHECK(is_refused(cube + replaced(on_a_foot, R"("0", "0", "1")", R"("0", "1", "1")"), "expected one of length 1"));
  CHECK(is_refused(cube + on_a_foot + "tangent = [\"1\", \"0\", \"1\"]\n", "expected one of length 1"));
  CHECK(is_refused(cube + on_a_foot + "state = \"slides+\"\n", "did you mean 'slides'?"));
  CHECK(is_refused(cube + on_a_foot + joined("pin", "pin", "ground", "at = [\"0\", \"0\", \"0\"]"),
                   "unknown kind of joint 'pin'"));
  CHECK(is_refused(cube + on_a_foot + joined("axle", "hinge", "ground", "at = [\"0\", \"0\", \"0\"]"), "missing axis"));
}

TEST_CASE("what no contact problem in space says is refused") {
  CHECK(is_refused(cube + on_a_foot + "bilateral = true\n", "a guide with friction"));
  CHECK(is_refused(cube + replaced(on_a_foot, "\"1/2\"", "{ static = \"1/2\", kinetic = \"1/3\" }"),
                   "static coefficient of its own"));
  CHECK(is_refused(
      "load = { symbol = \"F\" }\n" + cube + on_a_foot + "[[force]]\non = \"block\"\nis = [\"F\", \"0\", \"0\"]\n",
      "found no value of the load F"));
  const std::string lift = "[[body]]\nname = \"lift\"\nacceleration = [\"0\", \"0\", \"1\"]\n";
  CHECK(is_refused(lift + cube + joined("a", "ball", "ground", "at = [\"0\", \"0\", \"1\"]") +
                       joined("b", "ball", "lift", "at = [\"0\", \"0\", \"1\"]"),
                   "contradict each other"));
}

TEST_CASE("redundant links leave their forces open, and determine the motion") {
  const std::string hinge = "axis = [\"0\", \"0\", \"1\"]\nat = ";
  const SolvedSpace door =
      test::solved_text(cube + "[[force]]\non = \"block\"\nat = [\"0\", \"0\", \"0\"]\nis = [\"0\", \"3\", \"0\"]\n" +
                        joined("lower", "hinge", "ground", hinge + "[\"-1\", \"0\", \"0\"]") +
                        joined("upper", "hinge", "ground", hinge + "[\"-1\", \"0\", \"2\"]"));
  REQUIRE(door.motions.size() == 1);
  const SpaceMotion& motion = door.motions.front();
  CHECK(*motion.accelerations[1].lower == Rational(3, 2));  // 3 / (m + I) about the hinge
  CHECK(*motion.accelerations[5].lower == Rational(3, 2));
  CHECK(motion.accelerations[5].is_point());
  const auto names = force_names(door.scene.mechanism);
  const auto open = static_cast<std::size_t>(std::ranges::find(names, "R_lower_z") - names.begin());
  CHECK(!motion.forces[open]);
}

TEST_CASE("a block on rails without friction falls as they let it") {
  const std::string rail = R"(
[[contact]]
name = "rail"
of = "block"
point = ["0", "0", "0"]
normal = ["-3/5", "0", "4/5"]
through = ["0", "0", "1"]
bilateral = true
)";
  const SolvedSpace sliding = test::solved_text(cube + rail);
  REQUIRE(sliding.motions.size() == 1);
  CHECK(*sliding.motions.front().accelerations[0].lower == Rational(-24, 5));  // - g sin cos
  CHECK(*sliding.motions.front().accelerations[2].lower == Rational(-18, 5));  // - g sin^2
  CHECK(*sliding.motions.front().forces[0]->lower == 8);
}

TEST_CASE("an angle gives a sliding velocity its direction") {
  const std::string text =
      "angles = { theta = { cos = \"c\", sin = \"s\", domain = \"c > 0\" } }\n"
      "parameters = { v = \"v > 0\" }\n" +
      cube + "velocity = [\"v*c\", \"v*s\", \"0\"]\n" + on_a_foot;
  const Mechanism mechanism = parse_mechanism(
      "schema = \"slipproof/mechanism/1\"\nname = \"slides\"\ndimension = 3\ngravity = [\"0\", \"0\", \"-10\"]\n" +
          text,
      "in space");
  const MechanismContact& contact = mechanism.contacts.front();
  CHECK(contact.start == ElementKind::Start::slides_forward);
  REQUIRE(contact.sliding.size() == 2);
  MechanismScene scene{"slides", mechanism, default_values(mechanism), std::nullopt, {}};
  scene.values.parameters = {7};
  scene.values.angles = {{Rational(3, 5), Rational(4, 5)}};
  const SolvedSpace slides = solve_space(scene);
  REQUIRE(slides.motions.size() == 1);
  CHECK(*slides.motions.front().slips[0]->lower > 53);
  CHECK(*slides.motions.front().slips[0]->upper < 54);
}

TEST_CASE("a dimension that is none is the only mistake that is told") {
  const std::string text =
      "schema = \"slipproof/mechanism/1\"\nname = \"m\"\ndimension = 4\ngravity = \"none\"\n" + cube;
  std::string found;
  try {
    parse_mechanism(text, "m.toml");
  } catch (const InputError& error) {
    found = error.what();
  }
  CHECK(found == "m.toml:3:13: dimension: found '4', expected 2 for a mechanism in the plane, or 3 for one in space");
}
