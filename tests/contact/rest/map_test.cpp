// Regions of two loads in which a scene can rest, by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "base/input/diagnostic.hpp"
#include "contact/rest/rest_text.hpp"
#include "mechanics/reading/read_mechanism.hpp"

using namespace slipproof;

namespace {

/// Gravity is 10; X and Y are parameters, both 0.
MechanismScene loaded_scene(const std::string& bodies, bool in_space = false) {
  const std::string parameters = "[parameters]\nX = { domain = \"X >= -100\" }\nY = { domain = \"Y >= -100\" }\n";
  const Mechanism mechanism =
      parse_mechanism("schema = \"slipproof/mechanism/1\"\nname = \"loaded\"\n" +
                          std::string(in_space ? "dimension = 3\ngravity = [\"0\", \"0\", \"-10\"]\n"
                                               : "gravity = [\"0\", \"-10\"]\n") +
                          parameters + bodies,
                      "loaded");
  MechanismScene scene{"", mechanism, default_values(mechanism), std::nullopt, {}};
  set_value(scene, "X", 0), set_value(scene, "Y", 0);
  return scene;
}

RestMap map_of(const MechanismScene& scene, const std::string& x = "X", const std::string& y = "Y") {
  RestQuestions questions;
  questions.map = RestMapQuestion{x, y, {}, {}};
  const RestAnswer answer = find_rest(scene, questions);
  REQUIRE(answer.map);
  return *answer.map;
}

using Loads = std::array<Rational, 2>;
std::vector<Loads> corners(const RestMap& map) {
  std::vector<Loads> result;
  for (const RestMap::Corner& corner : map.inside) result.push_back({corner.x, corner.y});
  std::ranges::sort(result);
  return result;
}
bool can_rest(MechanismScene scene, const RestMap& map, const Rational& x, const Rational& y) {
  set_value(scene, map.x, x), set_value(scene, map.y, y);
  return find_rest(scene).decision.can == true;
}

std::string loaded_body(const std::string& at, const std::string& more) {
  return "[[body]]\nname = \"b\"\nmass = \"1\"\ninertia = \"1\"\nat = [" + at + "]\n" + more;
}
std::string loaded_touch(const std::string& name, const std::string& point, const std::string& normal,
                         const std::string& mu) {
  return "[[contact]]\nname = \"" + name + "\"\nof = \"b\"\npoint = [" + point + "]\nnormal = [" + normal +
         "]\nthrough = [\"0\", \"0\"]\nfriction = \"" + mu + "\"\n";
}
std::string two_loads(const std::string& at, const std::string& is) {
  return "[[force]]\non = \"b\"\nat = [" + at + "]\nis = [" + is + "]\n";
}

}  // namespace

TEST_CASE("a table pulled by H and pressed by P at its edge slides or tips about a foot") {
  // m g = 80, b = 2/5, c = h = 4/5, mu = 1/4. It tips to the right beyond H + P/2 = 40, to the left beyond -H - 3/2 P =
  // 40, and slides beyond |H| = 20 + P/4.
  const MechanismScene scene =
      read_scene(SLIPPROOF_SOURCE_DIR "/cases/rest/table-pulled-at-its-edge.toml", Dimensions::any);
  const RestMap map = map_of(scene, "H", "P");
  CHECK(map.exact);
  CHECK(map.borders.size() == 4);
  CHECK(corners(map) ==
        std::vector<Loads>{
            {-80, 240}, {-16, -16}, {Rational(80, 7), Rational(-240, 7)}, {Rational(80, 3), Rational(80, 3)}});
  const Rational out(Integer(1001), Integer(1000));  // around (0, 40), which is inside
  for (const Loads& corner : corners(map)) {
    CHECK(can_rest(scene, map, corner[0], corner[1]));
    CHECK_FALSE(can_rest(scene, map, out * corner[0], 40 + out * (corner[1] - 40)));
  }
}

TEST_CASE("a cube pushed by two forces at its base rests in a disc of radius mu m g") {
  std::string text =
      "[[body]]\nname = \"b\"\nmass = \"1\"\ninertia = [\"1\", \"1\", \"1\"]\nat = [\"0\", \"0\", \"1\"]\n";
  int number = 0;
  for (const char* corner : {R"("1", "1", "-1")", R"("1", "-1", "-1")", R"("-1", "1", "-1")", R"("-1", "-1", "-1")"}) {
    text += "[[contact]]\nname = \"c" + std::to_string(++number) + "\"\nof = \"b\"\npoint = [" + corner +
            "]\nnormal = [\"0\", \"0\", \"1\"]\nthrough = [\"0\", \"0\", \"0\"]\nfriction = \"1/2\"\n";
  }
  const RestMap map = map_of(loaded_scene(text + two_loads(R"("0", "0", "-1")", R"("X", "Y", "0")"), true));
  CHECK(map.decided);
  CHECK(map.gap < 0.01);
  CHECK(map.inside.size() > 8);
  for (const RestMap::Corner& corner : map.inside) CHECK(corner.x * corner.x + corner.y * corner.y <= 25);
  for (const RestMap::Border& border : map.borders) {
    CHECK(border.most * border.most >= 25 * (border.x * border.x + border.y * border.y));
  }
}

TEST_CASE("a region without end is cut by a frame") {
  // A ladder of weight 10 from (-3, 0) to (0, 4) at a smooth pane, mu = 1/2 at its foot; X pushes its middle to the
  // pane, Y presses its head down. The pane pushes (15 + 3 Y + 2 X)/4 >= 0; the foot slips beyond Y - 2 X = 5 and
  // beyond 2 X - 5 Y = 35.
  const MechanismScene scene =
      loaded_scene(loaded_body(R"("-3/2", "2")", "") + loaded_touch("foot", R"("-3/2", "-2")", R"("0", "1")", "1/2") +
                   loaded_touch("head", R"("3/2", "2")", R"("-1", "0")", "0") +
                   two_loads(R"("0", "0")", R"("X", "0")") + two_loads(R"("3/2", "2")", R"("0", "-Y")"));
  const RestMap map = map_of(scene);
  CHECK(map.exact);
  CHECK(map.borders.size() == 3);
  CHECK(map.x_frame.to);  // chosen
  CHECK(map.y_frame.to);
  CHECK_FALSE(map.x_frame.from);
  for (const Loads& corner : {Loads{Rational(-15, 4), Rational(-5, 2)}, Loads{Rational(15, 8), Rational(-25, 4)}}) {
    const std::vector<Loads> found = corners(map);
    CHECK(std::ranges::find(found, corner) != found.end());
  }
  for (const RestMap::Corner& corner : map.inside) CHECK(can_rest(scene, map, corner.x, corner.y));
}

TEST_CASE("a region may be a line, or nothing") {
  const std::string on_ice = loaded_body(R"("0", "0")", "") + loaded_touch("ice", R"("0", "0")", R"("0", "1")", "0");
  const RestMap line = map_of(loaded_scene(on_ice + two_loads(R"("0", "0")", R"("X", "Y")")));  // X = 0 and Y <= 10
  CHECK(line.exact);
  REQUIRE(line.inside.size() == 2);
  CHECK(corners(line)[1] == Loads{0, 10});
  CHECK(line.y_frame.from);
  const RestMap nothing = map_of(loaded_scene(on_ice + two_loads(R"("0", "0")", R"("1", "X + Y")")));
  CHECK(nothing.none);
  CHECK(nothing.inside.empty());
  REQUIRE(nothing.borders.size() == 1);
  CHECK(nothing.borders[0].motion.power.sign() > 0);
}

TEST_CASE("what is no load has no map") {
  const std::string on_ice = loaded_body(R"("0", "0")", "") + loaded_touch("ice", R"("0", "0")", R"("0", "1")", "0");
  const MechanismScene both = loaded_scene(on_ice + two_loads(R"("0", "0")", R"("X*Y", "0")"));
  CHECK_THROWS_AS(map_of(both), InputError);
  const MechanismScene squared = loaded_scene(on_ice + two_loads(R"("0", "0")", R"("X^2", "Y")"));
  CHECK_THROWS_AS(map_of(squared), InputError);
  CHECK_THROWS_AS(map_of(squared, "Y", "Y"), InputError);
}
