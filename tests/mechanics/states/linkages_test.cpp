// Linkages from one or two rates have the velocities that one derives by hand, and are the mechanisms that one writes
// the long way.
#include <doctest/doctest.h>

#include <string>

#include "base/input/text_file.hpp"
#include "mechanics/bodies/bodies.hpp"
#include "mechanics/checks/checks.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/scene/scene.hpp"
#include "mechanics/states/same_mechanism.hpp"
#include "support/replaced.hpp"

using namespace slipproof;
using test::check_same_mechanism;
using test::is_identical;
using test::replaced;

namespace {

std::string shipped_linkage(const std::string& name) {
  return read_text_file(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/linkages/" + name + ".toml");
}

Mechanism linkage(const std::string& text) {
  return parse_mechanism(text, "linkage.toml");
}

const Body& body(const Mechanism& mechanism, const std::string& name) {
  for (const Body& one : mechanism.bodies->bodies) {
    if (one.name == name) return one;
  }
  FAIL("no such body");
  return mechanism.bodies->bodies.front();
}

void check_planar(const Mechanism& mechanism, const std::string& name, const std::string& x, const std::string& y,
                  const std::string& spin) {
  const Body& one = body(mechanism, name);
  CAPTURE(name);
  CAPTURE(to_string(one.velocity.x.expression));
  CAPTURE(to_string(one.velocity.y.expression));
  CAPTURE(to_string(one.spin.z.expression));
  CHECK(is_identical(mechanism, one.velocity.x.expression, x));
  CHECK(is_identical(mechanism, one.velocity.y.expression, y));
  CHECK(is_identical(mechanism, one.spin.z.expression, spin));
}

/// As one writes it without joints that place, and without [state].
std::string placed(const std::string& at, const std::string& turn, const std::string& velocity,
                   const std::string& spin) {
  return "at = " + at + "\n" + turn + "\nvelocity = " + velocity + "\nspin = " + spin + "\n";
}

std::string without_state(std::string text) {
  return text.substr(0, text.find("[state]"));
}

}  // namespace

TEST_CASE("a finger whose tip stays on a table moves as its middle joint says") {
  const std::string text = shipped_linkage("finger");
  const Mechanism finger = linkage(text);
  const std::string c12 = "(c1*c2 - s1*s2)", s12 = "(s1*c2 + c1*s2)";
  const std::string w1 = "(-w*" + c12 + "/(c1 + " + c12 + "))", w2 = "(w*c1/(c1 + " + c12 + "))";
  const std::string x1 = "-l*s1*" + w1 + "/2", y1 = "l*c1*" + w1 + "/2";
  const std::string x2 = "-l*s1*" + w1 + " - l*" + s12 + "*" + w2 + "/2",
                    y2 = "l*c1*" + w1 + " + l*" + c12 + "*" + w2 + "/2";
  check_planar(finger, "upper", x1, y1, w1);
  check_planar(finger, "lower", x2, y2, w2);
  std::string at_length = replaced(
      without_state(text), "by = \"knuckle\"\nangle = \"knuckle\"\n",
      placed("[\"l*c1/2\", \"l*s1/2\"]", "angle = \"knuckle\"", "[\"" + x1 + "\", \"" + y1 + "\"]", "\"" + w1 + "\""));
  at_length = replaced(
      at_length, "by = \"middle\"\nangle = \"bend\"\n",
      placed("[\"l*c1 + l*" + c12 + "/2\", \"l*s1 + l*" + s12 + "/2\"]", "angle = [\"" + c12 + "\", \"" + s12 + "\"]",
             "[\"" + x2 + "\", \"" + y2 + "\"]", "\"" + w2 + "\""));
  check_same_mechanism(finger, linkage(at_length));
}

TEST_CASE("a crank drives a slider, which is a pair of guides") {
  const std::string text = shipped_linkage("crank-slider");
  const Mechanism engine = linkage(text);
  const std::string rod = "(-w*c1*s2/(s1*c2))";
  const std::string x = "-r*w*s1 + l*s2*" + rod + "/2", y = "r*w*c1 + l*c2*" + rod + "/2",
                    piston = "-r*w*s1 + l*s2*" + rod;
  check_planar(engine, "crank", "0", "0", "w");
  check_planar(engine, "rod", x, y, rod);
  check_planar(engine, "piston", piston, "0", "0");
  std::string at_length = replaced(without_state(text), "by = \"bearing\"\nangle = \"crank\"\n",
                                   placed("[\"0\", \"0\"]", "angle = \"crank\"", "[\"0\", \"0\"]", "\"w\""));
  const std::size_t from = at_length.find("by = \"crank_pin\""), to = at_length.find("shape", from);
  at_length.replace(from, to - from,
                    placed("[\"r*c1 + l*c2/2\", \"r*s1 - l*s2/2\"]", "angle = [\"c2\", \"-s2\"]",
                           "[\"" + x + "\", \"" + y + "\"]", "\"" + rod + "\""));
  at_length = replaced(at_length, "by = \"cylinder\"\ndisplacement = \"r*c1 + l*c2\"\n",
                       placed("[\"r*c1 + l*c2\", \"0\"]", "", "[\"" + piston + "\", \"0\"]", "\"0\""));
  std::string guides;
  for (const char* guide : {"front", "back"}) {
    guides += std::string("[[contact]]\nname = \"cylinder_") + guide + "\"\nof = \"piston\"\npoint = [\"" +
              (guides.empty() ? "b/2" : "-b/2") +
              "\", \"0\"]\nnormal = [\"0\", \"1\"]\nthrough = [\"0\", \"0\"]\nfriction = \"mu\"\nbilateral = true\n"
              "state = \"slides-\"\n";
  }
  const std::size_t joint = at_length.find("[[joint]]\nname = \"cylinder\""), force = at_length.find("[[force]]");
  at_length.replace(joint, force - joint, guides);
  check_same_mechanism(engine, linkage(at_length));
}

TEST_CASE("a plate moves below the tip of a four-bar as the rate of the crank says") {
  const std::string text = shipped_linkage("four-bar");
  const Mechanism bars = linkage(text);
  const std::string coupler = "(a*w*(s1*c3 - c1*s3)/(b*(s3*c2 - c3*s2)))",
                    rocker = "(a*w*(s1*c2 - c1*s2)/(k*(s3*c2 - c3*s2)))";
  const std::string x1 = "-a*w*s1/2", y1 = "a*w*c1/2", x2 = "-a*w*s1 - b*s2*" + coupler + "/2",
                    y2 = "a*w*c1 + b*c2*" + coupler + "/2", x3 = "-k*s3*" + rocker + "/2", y3 = "k*c3*" + rocker + "/2",
                    plate = "a*w*c1 + ((b/2 + e)*c2 + h*s2)*" + coupler;
  check_planar(bars, "crank", x1, y1, "w");
  check_planar(bars, "coupler", x2, y2, coupler);
  check_planar(bars, "rocker", x3, y3, rocker);
  CHECK(is_identical(bars, body(bars, "plate").velocity.y.expression, plate));
  std::string at_length =
      replaced(without_state(text), "by = \"A\"\nangle = \"crank\"\n",
               placed("[\"a*c1/2\", \"a*s1/2\"]", "angle = \"crank\"", "[\"" + x1 + "\", \"" + y1 + "\"]", "\"w\""));
  const std::size_t from = at_length.find("by = \"B\""), to = at_length.find("shape", from);
  at_length.replace(from, to - from,
                    placed("[\"a*c1 + b*c2/2\", \"a*s1 + b*s2/2\"]", "angle = \"coupler\"",
                           "[\"" + x2 + "\", \"" + y2 + "\"]", "\"" + coupler + "\""));
  at_length = replaced(at_length, "by = \"D\"\nangle = \"rocker\"\n",
                       placed("[\"a*c1 + b*c2 - k*c3/2\", \"k*s3/2\"]", "angle = \"rocker\"",
                              "[\"" + x3 + "\", \"" + y3 + "\"]", "\"" + rocker + "\""));
  at_length = replaced(at_length, "by = \"rail\"\ndisplacement = \"a*s1 + b*s2/2 + e*s2 - h*c2\"\n",
                       "at = [\"0\", \"a*s1 + b*s2/2 + e*s2 - h*c2\"]\nvelocity = [\"0\", \"" + plate + "\"]\n");
  check_same_mechanism(bars, linkage(at_length));
}

TEST_CASE("linkages change their motions where the page says") {
  struct Change {
    std::string scene;
    Rational load;
    std::string below, above;
  };
  const Rational near(1, 100000);
  for (const Change& one : {Change{"finger", Rational(39666979) / 5780000000, "slip+", "lift"},
                            Change{"crank-slider", Rational(580193, 18688), "slip-~/slip-~", "slip-/slip-"},
                            Change{"four-bar", Rational(-1562133707447) / 42716362500, "lift", "slip-"}}) {
    CAPTURE(one.scene);
    const auto scene = read_scene(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/linkages/scenes/" + one.scene + ".toml");
    CHECK(check_mechanism(scene.mechanism).empty());
    const FrictionProblem problem = friction_problem(scene.mechanism, scene.values);
    for (const bool above : {false, true}) {
      const MotionsAtLoad found = motions_of(problem, above ? one.load + near : one.load - near);
      REQUIRE(found.motions.size() == 1);
      CHECK(equal_modes(found.motions.front().modes) == (above ? one.above : one.below));
    }
  }
}

TEST_CASE("a leg of two hinges in space moves as the rates of its hinges say") {
  const std::string text = shipped_linkage("hinge-chain");
  const Mechanism leg = linkage(text);
  const std::string thigh = R"(["-l*p*s1/2", "l*p*c1/2", "0"])",
                    shin = R"(["-l*p*s1 - l*(p*c2*s1 + q*s2*c1)/2", "l*p*c1 + l*(p*c2*c1 - q*s2*s1)/2", "-l*q*c2/2"])",
                    spin = R"(["-q*s1", "q*c1", "p"])";
  std::string at_length =
      replaced(without_state(text), "by = \"hip\"\nangle = \"hip\"\n",
               placed(R"(["l*c1/2", "l*s1/2", "0"])", R"(turn = { axis = ["0", "0", "1"], angle = "hip" })", thigh,
                      R"(["0", "0", "p"])"));
  at_length = replaced(at_length, "by = \"knee\"\nangle = \"knee\"\n",
                       placed(R"(["l*c1 + l*c1*c2/2", "l*s1 + l*s1*c2/2", "-l*s2/2"])",
                              R"x(turn = ["(1 + c1)*(1 + c2)", "-s1*s2", "(1 + c1)*s2", "s1*(1 + c2)"])x", shin, spin));
  check_same_mechanism(leg, linkage(at_length));
  const Body& lower = body(leg, "shin");
  CHECK(is_identical(leg, lower.velocity.x.expression, "-l*p*s1 - l*(p*c2*s1 + q*s2*c1)/2"));
  CHECK(is_identical(leg, lower.velocity.z.expression, "-l*q*c2/2"));
  CHECK(is_identical(leg, lower.spin.x.expression, "-q*s1"));
  CHECK(is_identical(leg, lower.spin.z.expression, "p"));
}
