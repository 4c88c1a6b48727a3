#include "report/scenes/mechanism_report.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/number/parse.hpp"
#include "contact/problem/every_push.hpp"
#include "mechanics/scene/bicycle_scene.hpp"
#include "mechanics/scene/solve_mechanism.hpp"

using namespace slipproof;
using Json = nlohmann::ordered_json;

namespace {

void set(MechanismScene& scene, std::string_view symbol, const Rational& value) {
  scene.values.parameters[bicycle_parameter(symbol)] = value;
}

/// The ambiguous region of Assertion 5, as three motions at F = 7/20.
MechanismScene ambiguous(std::optional<Rational> F) {
  MechanismScene scene{"three motions", bicycle_mechanism(), default_values(bicycle_mechanism()), std::move(F), {}};
  for (const std::string_view one : {"M", "R", "h", "I2", "I3", "r1", "r2", "L", "J", "g"}) set(scene, one, 1);
  set(scene, "b2", Rational(1, 2));
  set(scene, "b3", Rational(1, 2));
  set(scene, "f", 4);
  return scene;
}

/// b = b1: slip of the front wheel is a continuum at F0 = 2/3.
MechanismScene at_b1(std::optional<Rational> F) {
  MechanismScene scene = ambiguous(std::move(F));
  set(scene, "b2", 1);
  set(scene, "b3", 1);
  return scene;
}

std::string solved_json(const MechanismScene& scene) {
  const SolvedMechanism solved = solve_mechanism(scene);
  return solve_json(solved, for_every_push(solved.problem));
}

Json document(const MechanismScene& scene) {
  return Json::parse(solved_json(scene));
}
std::string text(const MechanismScene& scene) {
  const SolvedMechanism solved = solve_mechanism(scene);
  return text_of(solve_document(solved, for_every_push(solved.problem), 6));
}

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> result;
  for (const auto& [key, value] : object.items()) result.push_back(key);
  return result;
}

}  // namespace

TEST_CASE("at a load: every motion with exact strings, every other mode rejected with a margin") {
  const Json j = document(ambiguous(Rational(7, 20)));
  CHECK(keys(j).front() == "schema");
  CHECK(j["schema"] == "slipproof/solve/2");
  CHECK(j["scene"] == "three motions");
  CHECK(j["not_modelled"].empty());
  CHECK(j["load"] == Json{{"symbol", "F"}, {"value", "7/20"}});
  CHECK_FALSE(j.contains("cells"));
  REQUIRE(j["motions"].size() == 3);
  CHECK(j["rejected"].size() == 13);
  CHECK(j["continua"].empty());
  for (const Json& motion : j["motions"]) {
    CHECK(keys(motion["accelerations"]) ==
          std::vector<std::string>{"a", "a_y", "phi", "eps1", "eps2", "eps3", "gap2", "slip2", "gap3", "slip3"});
    CHECK(keys(motion["forces"]) == std::vector<std::string>{"T", "N2", "S2", "N3", "S3"});
    CHECK(motion["status"] == "strict");
  }
  // By hand: stick/stick has a = F/M0 = 7/60 and N2 + N3 = g; I1 = 0 and r1 = 1: the chain holds the pedal force, T =
  // -F.
  const Json& stick = j["motions"][0];
  CHECK(stick["modes"] == Json::array({"stick/stick"}));
  CHECK(stick["accelerations"]["a"] == "7/60");
  const Json& forces = stick["forces"];
  CHECK(parse_rational(forces["N2"].get<std::string>()) + parse_rational(forces["N3"].get<std::string>()) == 1);
  CHECK(forces["S3"] == "-7/60");
  CHECK(forces["T"] == "-7/20");
  for (const Json& r : j["rejected"]) {
    CHECK(keys(r) == std::vector<std::string>{"mode", "violated", "margin"});
    CHECK(parse_rational(r["margin"].get<std::string>()) < 0);
  }
}

TEST_CASE("without a load: ranges and cells, infinite ends are null and open") {
  const Json j = document(ambiguous(std::nullopt));
  CHECK(j["load"]["value"].is_null());
  CHECK_FALSE(j.contains("motions"));
  bool infinite = false;
  for (const Json& range : j["ranges"]) {
    for (const std::size_t end : {0U, 1U}) {
      CHECK(range["closed"][end].get<bool>() == !range["load"][end].is_null());
      infinite = infinite || range["load"][end].is_null();
    }
  }
  CHECK(infinite);
  CHECK(j["ranges"][0]["mode"] == "stick/stick");
  CHECK(j["ranges"][0]["load"][1] == "6/17");  // xi2 = f g M0 / (2 M3 + b0/b) = 12/34
  const Json& cells = j["cells"];
  CHECK(cells.front()["load"][0].is_null());
  CHECK(cells.back()["load"][1].is_null());
  for (const Json& cell : cells) CHECK_FALSE(cell["motions"].empty());
}

TEST_CASE("the motions of a cell are those of a load in it") {
  const Rational F(7, 20);
  const Json there = document(ambiguous(F)), open = document(ambiguous(std::nullopt));
  const auto number = [](const Json& x) { return parse_rational(x.get<std::string>()); };
  const auto contains = [&](const Json& cell) {
    const Json& ends = cell["load"];
    return (ends[0].is_null() || number(ends[0]) < F) && (ends[1].is_null() || F < number(ends[1]));
  };
  const auto& cells = open["cells"];
  const auto cell = std::find_if(cells.begin(), cells.end(), contains);
  REQUIRE(cell != cells.end());
  REQUIRE((*cell)["motions"].size() == there["motions"].size());
  for (std::size_t i = 0; i < there["motions"].size(); ++i) {
    const Json &over = (*cell)["motions"][i], &at = there["motions"][i];
    CHECK(over["modes"] == at["modes"]);
    for (const char* kind : {"accelerations", "forces"}) {
      for (const auto& [symbol, value] : at[kind].items()) {
        CAPTURE(symbol);
        CHECK(number(over[kind][symbol]["const"]) + number(over[kind][symbol]["per_load"]) * F == number(value));
      }
    }
  }
}

TEST_CASE("a continuum is reported with the range of each number") {
  const MechanismScene scene = at_b1(Rational(2, 3));
  const Json j = document(scene);
  REQUIRE(j["continua"].size() == 1);
  CHECK(j["continua"][0]["mode"] == "stick/slip+");
  CHECK(j["continua"][0]["ranges"]["N3"][0] == "0");  // where the front wheel begins to lift
  CHECK(text(scene).find("a continuum of motions") != std::string::npos);
  CHECK(text(scene).find("continua 1") != std::string::npos);
  CHECK(text(at_b1(std::nullopt)).find("{2/3}  a continuum of motions\n") != std::string::npos);
}

TEST_CASE("whether there is one motion whatever else pushes the bicycle, as the threshold worked out by hand has it") {
  MechanismScene scene = ambiguous(Rational(7, 20));  // f < min(w/2, b2 + J/(M b2), b3 + J/(M b3))/h = 1/2
  const auto told = [&](const Rational& f) {
    set(scene, "f", f);
    return document(scene)["every_q"];
  };
  CHECK(told(Rational(499, 1000)) == Json{{"verdict", "unique"}, {"by", "mode determinants"}});
  CHECK(text(scene).find("\nOne motion whatever else pushes it, by the mode determinants\n") != std::string::npos);
  const Json on = told(Rational(1, 2));
  CHECK(on["verdict"] == "not unique");
  CHECK(on["determinant"] == "0");
  CHECK(text(scene).find("\nNot one under all other forces: the determinant of " + on["mode"].get<std::string>() +
                         " is 0\n") != std::string::npos);
  scene.load.reset();
  CHECK(told(4)["verdict"] == "not unique");
  CHECK(text(scene).find("\nNot one under all other forces") != std::string::npos);
}

TEST_CASE("without J the output says that motions with a wheel off the road are not modelled") {
  MechanismScene scene = ambiguous(Rational(7, 20));
  scene.values.given[bicycle_parameter("J")] = false;
  const Json j = document(scene);
  CHECK(j["not_modelled"].size() == 2);
  CHECK(j["every_q"].is_null());
  CHECK(j["motions"].size() + j["rejected"].size() == 9);
  CHECK(text(scene).find("not modelled") != std::string::npos);
}

TEST_CASE("the last line of the text is the result") {
  CHECK(text(ambiguous(Rational(7, 20))).ends_with("\ns SOLVED motions 3 strict 3 continua 0 rejected 13\n"));
}

TEST_CASE("a scene's name may contain anything") {
  MechanismScene scene = ambiguous(std::nullopt);
  scene.name = "\"</script>\n\x01 \xff";
  CHECK(document(scene)["scene"].get<std::string>().starts_with("\"</script>\n\x01 "));
}
