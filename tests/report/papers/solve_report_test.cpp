#include "report/scenes/solve_report.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "base/number/parse.hpp"

using namespace slipproof;
using Json = nlohmann::ordered_json;

namespace {

/// The ambiguous region of Assertion 5, see tests/mechanics/bicycle_modes: three motions at F = 7/20.
Scene ambiguous(std::optional<Rational> F) {
  Scene scene;
  scene.name = "three motions";
  scene.bicycle = {1, 1, 1, Rational(1, 2), Rational(1, 2), 0, 1, 1, 1, 1, 1, Rational(1)};
  scene.road = {4, 1};
  scene.F = std::move(F);
  return scene;
}

/// b = b1: slip of the front wheel is a continuum at F0 = 2/3.
Scene at_b1(std::optional<Rational> F) {
  Scene scene = ambiguous(std::move(F));
  scene.bicycle.b2 = scene.bicycle.b3 = 1;
  return scene;
}

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> result;
  for (const auto& [key, value] : object.items()) result.push_back(key);
  return result;
}

const std::vector<std::string> quantities{"a",  "a_y", "phi",  "eps2", "eps3",  "S2",   "S3",
                                          "N2", "N3",  "gap2", "gap3", "slip2", "slip3"};

}  // namespace

TEST_CASE("at a force: every motion with exact strings, every other mode rejected with a margin") {
  const Json j = Json::parse(solve_json(SolvedScene(ambiguous(Rational(7, 20)))));
  CHECK(keys(j).front() == "schema");
  CHECK(j["schema"] == "slipproof/solve/1");
  CHECK(j["scene"] == "three motions");
  CHECK(j["detachment"] == true);
  CHECK(j["F"] == "7/20");
  REQUIRE(j["motions"].size() == 3);
  CHECK(j["rejected"].size() == 13);
  CHECK(j["continua"].empty());
  for (const Json& motion : j["motions"]) {
    std::vector<std::string> expected{"modes", "status"};
    expected.insert(expected.end(), quantities.begin(), quantities.end());
    CHECK(keys(motion) == expected);
    CHECK(motion["status"] == "strict");
  }
  // By hand: stick/stick has a = F/M0 = 7/60 and N2 + N3 = g.
  const Json& stick = j["motions"][0];
  CHECK(stick["modes"] == Json::array({"stick/stick"}));
  CHECK(stick["a"] == "7/60");
  CHECK(parse_rational(stick["N2"].get<std::string>()) + parse_rational(stick["N3"].get<std::string>()) == 1);
  CHECK(stick["S3"] == "-7/60");
  for (const Json& r : j["rejected"]) {
    CHECK(keys(r) == std::vector<std::string>{"mode", "violated", "margin"});
    CHECK(parse_rational(r["margin"].get<std::string>()) < 0);
  }
}

TEST_CASE("without a force: ranges and cells, infinite ends are null and open") {
  const Json j = Json::parse(solve_json(SolvedScene(ambiguous(std::nullopt))));
  CHECK(j["F"].is_null());
  CHECK_FALSE(j.contains("motions"));
  bool infinite = false;
  for (const Json& range : j["ranges"]) {
    CHECK(keys(range) == std::vector<std::string>{"mode", "F", "closed"});
    for (const std::size_t end : {0U, 1U}) {
      CHECK(range["closed"][end].get<bool>() == !range["F"][end].is_null());
      infinite = infinite || range["F"][end].is_null();
    }
  }
  CHECK(infinite);
  CHECK(j["ranges"][0]["mode"] == "stick/stick");
  CHECK(j["ranges"][0]["F"][1] == "6/17");  // xi2 = f g M0 / (2 M3 + b0/b) = 12/34
  const Json& cells = j["cells"];
  CHECK(cells.front()["F"][0].is_null());
  CHECK(cells.back()["F"][1].is_null());
  for (const Json& cell : cells) CHECK_FALSE(cell["motions"].empty());
}

TEST_CASE("a continuum is reported with its free parameter and what it leaves undetermined") {
  const Json j = Json::parse(solve_json(SolvedScene(at_b1(Rational(2, 3)))));
  REQUIRE(j["continua"].size() == 1);
  const Json& c = j["continua"][0];
  CHECK(c["mode"] == "stick/slip+");
  CHECK(c["F"] == Json::array({"2/3", "2/3"}));
  CHECK(c["parameters"] == Json::array({"N3"}));
  CHECK(c["ranges"][0][0] == "0");
  CHECK(c["directions"].size() == 1);
  const std::string text = solve_text(SolvedScene(at_b1(Rational(2, 3))));
  CHECK(text.find("a continuum of motions") != std::string::npos);
  CHECK(text.find("continua 1") != std::string::npos);
}

TEST_CASE("whether there is one motion whatever else pushes the bicycle, as the threshold worked out by hand has it") {
  Scene scene = ambiguous(Rational(7, 20));  // f < min(w/2, b2 + J/(M b2), b3 + J/(M b3))/h = 1/2
  const auto told = [&](const Rational& f) {
    scene.road.f = f;
    return Json::parse(solve_json(SolvedScene(scene)))["every_q"];
  };
  CHECK(told(Rational(499, 1000)) == Json{{"verdict", "unique"}, {"by", "mode determinants"}});
  CHECK(solve_text(SolvedScene(scene)).find("\nOne motion whatever else pushes it, by the mode determinants\n") !=
        std::string::npos);
  const Json on = told(Rational(1, 2));
  CHECK(on["verdict"] == "not unique");
  CHECK(on["determinant"] == "0");
  CHECK(solve_text(SolvedScene(scene))
            .find("\nNot one under all other forces: the determinant of " + on["mode"].get<std::string>() +
                  " is 0\n") != std::string::npos);
  scene.F.reset();
  CHECK(told(4)["verdict"] == "not unique");
  CHECK(solve_text(SolvedScene(scene)).find("\nNot one under all other forces") != std::string::npos);
}

TEST_CASE("without J the output says that motions with a wheel off the road are not modelled") {
  Scene scene = ambiguous(Rational(7, 20));
  scene.bicycle.J.reset();
  const SolvedScene solved(scene);
  const Json j = Json::parse(solve_json(solved));
  CHECK(j["detachment"] == false);
  CHECK(j["every_q"].is_null());
  CHECK(j["motions"].size() + j["rejected"].size() == 9);
  CHECK(solve_text(solved).find("not modelled") != std::string::npos);
}

TEST_CASE("chain tension only when asked") {
  const SolvedScene solved(ambiguous(Rational(7, 20)));
  CHECK(solve_json(solved).find("\"T\"") == std::string::npos);
  const Json j = Json::parse(solve_json(solved, {.chain = true}));
  // I1 = 0 and r1 = 1: the chain holds the pedal force, T = -F L.
  CHECK(j["motions"][0]["T"] == "-7/20");
}

TEST_CASE("the last line of the text is the result") {
  const std::string text = solve_text(SolvedScene(ambiguous(Rational(7, 20))));
  CHECK(text.ends_with("\ns SOLVED motions 3 strict 3 continua 0 rejected 13\n"));
}

TEST_CASE("a scene's name may contain anything") {
  Scene scene = ambiguous(std::nullopt);
  scene.name = "\"</script>\n\x01 \xff";
  const Json j = Json::parse(solve_json(SolvedScene(scene)));
  CHECK(j["scene"].get<std::string>().starts_with("\"</script>\n\x01 "));
}
