// Scenes whose rest is worked out by hand.
#include <doctest/doctest.h>

#include <string>

#include "base/input/diagnostic.hpp"
#include "contact/rest/rest_text.hpp"
#include "mechanics/reading/read_mechanism.hpp"

using namespace slipproof;
using test::plane_scene;
using test::space_scene;

namespace {

std::string at_point(const std::string& name, const std::string& of, const std::string& point,
                     const std::string& normal, const std::string& through, const std::string& mu,
                     const std::string& more = "") {
  return "[[contact]]\nname = \"" + name + "\"\nof = \"" + of + "\"\npoint = [" + point + "]\nnormal = [" + normal +
         "]\nthrough = [" + through + "]\nfriction = \"" + mu + "\"\n" + more;
}

/// A block 4 wide and 2 high, of mass 1, on its two lower corners; gravity leans by the tangent 3/4.
std::string block_on_slope(const std::string& mu, const std::string& more = "") {
  return "[[body]]\nname = \"block\"\nmass = \"1\"\ninertia = \"1\"\nat = [\"0\", \"1\"]\n" + more +
         at_point("upper", "block", R"("-2", "-1")", R"("0", "1")", R"("0", "0")", mu) +
         at_point("lower", "block", R"("2", "-1")", R"("0", "1")", R"("0", "0")", mu);
}
const std::string leaning = "gravity = [\"6\", \"-8\"]\n";

/// A cube of side 2 and mass 1 on its lower corners, with a push F along x or another direction, low down.
std::string cube_in_space(const std::string& mu, const std::string& push) {
  std::string text =
      "[load]\nsymbol = \"F\"\n[[body]]\nname = \"cube\"\nmass = \"1\"\ninertia = [\"1\", \"1\", \"1\"]\nat = "
      "[\"0\", \"0\", \"1\"]\n";
  int number = 0;
  for (const char* corner : {R"("1", "1", "-1")", R"("1", "-1", "-1")", R"("-1", "1", "-1")", R"("-1", "-1", "-1")"}) {
    text += at_point("c" + std::to_string(++number), "cube", corner, R"("0", "0", "1")", R"("0", "0", "0")", mu);
  }
  return text + "[[force]]\non = \"cube\"\nat = [\"0\", \"0\", \"-1\"]\nis = [" + push + "]\n";
}

bool is_point(const std::optional<ProvedEnd>& end, const Rational& value) {
  return end && end->lower == value && end->upper == value;
}

}  // namespace

TEST_CASE("a block on a slope rests up to tan = mu, where it only just does") {
  const RestAnswer rough = find_rest(plane_scene(block_on_slope("4/5"), leaning));
  CHECK(rough.decision.can == true);
  CHECK_FALSE(rough.decision.touching);
  CHECK(rough.must.must == true);
  CHECK(test::force(rough, "N_upper") + test::force(rough, "N_lower") == 8);
  CHECK(holds(rough.problem, *rough.push, rough.decision.forces));

  const RestAnswer border = find_rest(plane_scene(block_on_slope("3/4"), leaning));
  CHECK(border.decision.can == true);
  CHECK(border.decision.touching);

  const RestAnswer smooth = find_rest(plane_scene(block_on_slope("7/10"), leaning));
  CHECK(smooth.decision.can == false);
  REQUIRE(smooth.decision.fall);
  CHECK(smooth.decision.fall->power.sign() > 0);
  CHECK(smooth.must.must == false);
}

TEST_CASE("the friction that a slope needs, and the tilt that a block stands") {
  const Mechanism mechanism =
      parse_mechanism("schema = \"slipproof/mechanism/1\"\nname = \"a scene\"\n" + leaning +
                          "[parameters]\nmu = { domain = \"mu >= 0\" }\n" + block_on_slope("mu"),
                      "in the plane");
  MechanismScene scene{"", mechanism, default_values(mechanism), std::nullopt, {}};
  scene.values.parameters[0] = 1;
  RestQuestions questions;
  questions.parameter = "mu";
  const RestAnswer along = find_rest(scene, questions);
  REQUIRE(along.parameter);
  CHECK(along.parameter->monotone);
  CHECK(is_point(along.parameter->from, Rational(3, 4)));
  CHECK_FALSE(along.parameter->to);

  RestQuestions tilt;
  tilt.tilt = {{0, 0, 1}};
  const RestAnswer level = find_rest(plane_scene(block_on_slope("3")), tilt);
  REQUIRE(level.tilt);
  CHECK(is_point(level.tilt->tangent, 2));  // it tips where the corner is below the centre of mass
  const RestAnswer slides = find_rest(plane_scene(block_on_slope("1/3")), tilt);
  CHECK(is_point(slides.tilt->tangent, Rational(1, 3)));
}

TEST_CASE("a ladder against a smooth wall needs mu = half of its run over its rise") {
  const auto ladder = [](const std::string& mu) {
    return plane_scene("[[body]]\nname = \"ladder\"\nmass = \"1\"\ninertia = \"1\"\nat = [\"-3/2\", \"2\"]\n" +
                       at_point("foot", "ladder", R"("-3/2", "-2")", R"("0", "1")", R"("0", "0")", mu) +
                       at_point("head", "ladder", R"("3/2", "2")", R"("-1", "0")", R"("0", "0")", "0"));
  };
  CHECK(find_rest(ladder("3/8")).decision.can == true);
  CHECK(find_rest(ladder("3/8")).decision.touching);
  CHECK(find_rest(ladder("37/100")).decision.can == false);
  const RestAnswer rests = find_rest(ladder("2/5"));
  CHECK(rests.decision.can == true);
  CHECK(test::force(rests, "N_head") == Rational(15, 4));
}

TEST_CASE("the greatest push on a cube in space") {
  const RestAnswer along = find_rest(space_scene(cube_in_space("1/2", R"("F", "0", "0")")));
  REQUIRE(along.loads);
  CHECK(along.loads->to->lower <= 5);
  CHECK(along.loads->to->upper >= 5);
  CHECK(along.loads->to->upper - along.loads->to->lower <= Rational(1, 1'000'000));
  MechanismScene pushed = space_scene(cube_in_space("1/2", R"("F", "0", "0")"));
  pushed.load = 1;
  RestQuestions outwards;
  outwards.parameter = "F";  // searched as any parameter, it ends at the same place
  const RestAnswer searched = find_rest(pushed, outwards);
  CHECK_FALSE(searched.parameter->monotone);
  REQUIRE(searched.parameter->to);
  CHECK(searched.parameter->to->lower <= 5);
  CHECK(searched.parameter->to->upper >= 5);
  // Along the diagonal: (F, F) has the length 5 where F^2 = 25/2.
  const RestAnswer diagonal = find_rest(space_scene(cube_in_space("1/2", R"("F", "F", "0")")));
  const ProvedEnd& to = *diagonal.loads->to;
  CHECK(to.lower * to.lower <= Rational(25, 2));
  CHECK(to.upper * to.upper >= Rational(25, 2));
  CHECK(to.upper - to.lower <= Rational(1, 100'000'000));
  CHECK(-diagonal.loads->from->upper <= to.upper);
}

TEST_CASE("a load without end, with forces that each further unit needs") {
  // Pressed down at its middle by F, and pulled sideways by less than mu F: (3/10, 2/5) has half the length of 1. On
  // the circle itself, at 3/10 and 2/5, no polygon that is there at first has a point.
  const auto pressed = [](const std::string& push) {
    const RestAnswer answer = find_rest(space_scene(cube_in_space("1/2", push)));
    REQUIRE(answer.loads);
    CHECK(answer.loads->decided);
    return answer;
  };
  for (const char* push : {R"("F/4", "3*F/8", "-F")", R"("3*F/10", "2*F/5", "-F")"}) {
    const RestAnswer answer = pressed(push);
    CHECK_FALSE(answer.loads->to);
    REQUIRE(answer.loads->above);
    const EndlessLoad& above = *answer.loads->above;
    CHECK(holds(answer.problem, push_at(answer.problem, above.load), above.forces));
    CHECK(holds(answer.problem, push_at(answer.problem, std::nullopt), above.more));
    CHECK_FALSE(answer.loads->below);
    CHECK(answer.loads->from);
  }
  // Twice as far to the side it ends: 5 + F/2 = F along (3/5, 4/5).
  const RestAnswer pulled = pressed(R"("3*F/5", "4*F/5", "-F")");
  CHECK_FALSE(pulled.loads->above);
  REQUIRE(pulled.loads->to);
  CHECK(pulled.loads->to->lower <= 10);
  CHECK(pulled.loads->to->upper >= 10);
}

TEST_CASE("a cube in space that is pushed less, as much, and more than friction holds") {
  const auto pushed = [](const std::string& push) {
    MechanismScene scene = space_scene(cube_in_space("1/2", push));
    scene.load = 0;
    return find_rest(scene);
  };
  const RestAnswer less = pushed(R"("3", "39/10", "0")");
  CHECK(less.decision.can == true);
  CHECK(holds(less.problem, *less.push, less.decision.forces));
  const RestAnswer as_much = pushed(R"("3", "4", "0")");
  CHECK(as_much.decision.can == true);
  CHECK(as_much.decision.touching);
  const RestAnswer more = pushed(R"("3", "4.00001", "0")");
  CHECK(more.decision.can == false);
  CHECK(more.decision.fall->power.sign() > 0);
}

TEST_CASE("a wedged block can rest and can fall") {
  // Between two walls, nothing below: with mu = 1 friction holds any weight, and nothing makes the walls push.
  const RestAnswer wedged =
      find_rest(plane_scene("[[body]]\nname = \"block\"\nmass = \"1\"\ninertia = \"1\"\nat = [\"0\", \"0\"]\n" +
                            at_point("l1", "block", R"("-1", "1")", R"("1", "0")", R"("-1", "0")", "1") +
                            at_point("l2", "block", R"("-1", "-1")", R"("1", "0")", R"("-1", "0")", "1") +
                            at_point("r1", "block", R"("1", "1")", R"("-1", "0")", R"("1", "0")", "1") +
                            at_point("r2", "block", R"("1", "-1")", R"("-1", "0")", R"("1", "0")", "1")));
  CHECK(wedged.decision.can == true);
  CHECK(wedged.must.must == false);
  CHECK(wedged.must.plane);
}

TEST_CASE("what moves is refused, with its place") {
  const std::string moving = block_on_slope("1", "velocity = [\"1\", \"0\"]\n");
  CHECK_THROWS_AS(find_rest(plane_scene(moving)), InputError);
}

TEST_CASE("without friction or links that hold, a virtual motion proves the fall") {
  const RestAnswer falls =
      find_rest(plane_scene("[[body]]\nname = \"block\"\nmass = \"2\"\ninertia = \"1\"\nat = [\"0\", \"0\"]\n" +
                            at_point("only", "block", R"("1", "-1")", R"("0", "1")", R"("0", "-1")", "1")));
  CHECK(falls.decision.can == false);
  REQUIRE(falls.decision.fall);
  Rational power;
  for (std::size_t i = 0; i < falls.problem.f.size(); ++i) power += falls.problem.f[i] * falls.decision.fall->rates[i];
  CHECK(power == falls.decision.fall->power);
}
