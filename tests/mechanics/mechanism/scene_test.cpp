#include "mechanics/scene/scene.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "base/number/parse.hpp"
#include "mechanics/points/degrees.hpp"

using namespace slipproof;

namespace {

const std::string crate =
    "mechanism = \"block-on-incline\"\n[values]\nm = \"10\"\nb = \"2/5\"\nh = \"0.3\"\nI = \"0.8\"\nmu_s = \"0.8\"\n"
    "mu_k = \"0.6\"\ng = \"9.81\"\n";

MechanismScene with_angle(const std::string& angle) {
  return parse_scene(crate + "theta = " + angle + "\n", "folder/crate.toml");
}

}  // namespace

TEST_CASE("a scene has exact values, and its name from its file") {
  const MechanismScene scene = with_angle("{ cos = \"4/5\", sin = \"3/5\" }");
  CHECK(scene.name == "crate");
  CHECK_FALSE(scene.load);
  CHECK(scene.values.parameters[1] == Rational(2, 5));
  CHECK(scene.values.parameters[6] == Rational(981, 100));
  CHECK(scene.notes.empty());
  const FrictionProblem problem = friction_problem(scene.mechanism, scene.values);
  CHECK(problem.has_load);
  CHECK(problem.equations[0].constant == Rational(-10) * Rational(981, 100) * Rational(3, 5));
}

TEST_CASE("an angle is a rational point in each of its forms") {
  const auto point = [](const std::string& angle) { return with_angle(angle).values.angles[0]; };
  CHECK(point("{ tan = \"3/4\" }").cosine == Rational(4, 5));
  CHECK(point("{ tan = \"3/4\" }").sine == Rational(3, 5));
  CHECK(point("{ tan_half = \"1/3\" }").cosine == Rational(4, 5));
  CHECK(point("{ tan = \"0\" }").sine == 0);
  CHECK(point("{ degrees = \"360\" }").cosine == 1);
}

TEST_CASE("degrees are the nearest rational angle, and the difference is told") {
  const MechanismScene scene = with_angle("{ degrees = \"30\" }");
  REQUIRE(scene.notes.size() == 1);
  CHECK(scene.notes[0].starts_with("theta is the rational angle nearest to 30 degrees: it differs by "));
  for (const char* text : {"30", "-30", "89.999", "91", "179.999999", "-179.5", "400", "1e-9", "725.5"}) {
    CAPTURE(text);
    const Rational degrees(parse_rational(text));
    const AngleFromDegrees angle = angle_from_degrees(degrees);
    CHECK(Rational(angle.point.cosine * angle.point.cosine + angle.point.sine * angle.point.sine) == 1);
    const double wanted = degrees.to_double() * std::acos(-1.0) / 180;
    CHECK(angle.point.cosine.to_double() == doctest::Approx(std::cos(wanted)).epsilon(1e-12));
    CHECK(angle.point.sine.to_double() == doctest::Approx(std::sin(wanted)).epsilon(1e-12));
    CHECK(std::abs(angle.difference.to_double()) < 1e-13);
  }
  for (const int quarter : {0, 90, 180, -90, 270, 3690}) {
    const AngleFromDegrees angle = angle_from_degrees(quarter);
    CHECK(angle.difference == 0);
    CHECK(Rational(angle.point.cosine * angle.point.sine) == 0);
  }
  const AngleFromDegrees steep = angle_from_degrees(Rational(180) - parse_rational("1e-400"));
  CHECK(steep.point.cosine == -1);
  CHECK(steep.difference == parse_rational("1e-400"));
}

TEST_CASE("states of a scene come before those of the file, and optional parameters may be absent") {
  const std::string text =
      "mechanism = \"bicycle\"\n[values]\nM = \"94\"\nR = \"0.3\"\nh = \"0.56\"\nb2 = \"0.34\"\nb3 = \"0.68\"\nI1 = "
      "\"0.01\"\n"
      "I2 = \"0.12\"\nI3 = \"0.2\"\nr1 = \"0.09\"\nr2 = \"0.036\"\nL = \"0.17\"\nf = \"0.8\"\ng = \"9.81\"\nexternal = "
      "\"0\"\n";
  const MechanismScene plain = parse_scene(text, "x.toml");
  CHECK_FALSE(plain.values.given[11]);
  const FrictionProblem problem = friction_problem(plain.mechanism, plain.values);
  CHECK_FALSE(problem.elements[0].kind.lifts);
  const MechanismScene sliding = parse_scene(text + "[state]\nfront = \"slides-\"\n", "x.toml");
  const FrictionProblem slides = friction_problem(sliding.mechanism, sliding.values);
  CHECK(slides.elements[1].kind.start == ElementKind::Start::slides_backward);
  CHECK(slides.elements[0].kind.start == ElementKind::Start::rest);
}

TEST_CASE("along another parameter the file's load must have a value, and the parameter need not") {
  const std::string text =
      "mechanism = \"ladder\"\nalong = \"d\"\n[values]\nm = \"12\"\nl = \"2\"\nI = \"16\"\nmu_f = \"0.5\"\nmu_w = "
      "\"0.2\"\n"
      "g = \"9.81\"\ntheta = { tan_half = \"1/2\" }\nW = \"100\"\n";
  const MechanismScene scene = parse_scene(text, "x.toml");
  CHECK_FALSE(scene.load);
  CHECK(scene.mechanism.load->symbol == "d");
  CHECK(to_string(friction_problem(scene.mechanism, scene.values).load_domain) == "[-2, 2]");
  CHECK(parse_scene(text + "d = \"1\"\n", "x.toml").load == Rational(1));
  CHECK_THROWS_WITH(parse_scene(text + "d = \"3\"\n", "x.toml"),
                    "x.toml:12:5: d: found '3', expected a value in [-2, 2]");
}

TEST_CASE("scenes of mechanisms are told from others") {
  CHECK(is_mechanism_scene("mechanism = \"x\"\n"));
  CHECK_FALSE(is_mechanism_scene("name = \"x\"\n[bicycle]\nR = \"1\"\n"));
  CHECK_FALSE(is_mechanism_scene("mechanism = "));
}
