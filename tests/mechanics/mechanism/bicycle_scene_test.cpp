#include "mechanics/scene/bicycle_scene.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/input/text_file.hpp"
#include "base/number/parse.hpp"

using namespace slipproof;

namespace {

constexpr const char* full_scene = R"(
name = "city bicycle"
[bicycle]
R = "0.34"
h0 = "1.05"
b2 = "0.45"
b3 = "0.60"
I1 = "0.01"
I2 = "0.12"
I3 = "0.12"
r1 = "0.09"
r2 = "0.045"
L = "0.17"
M = "85"
J = "12"
[road]
f = "0.8"
g = "9.81"
[force]
kind = "internal"
F = "300"
)";

constexpr const char* reduced_scene = R"(
[bicycle]
R = "0.4"
h = "0.6"
b = "0.53"
M2 = "0.1"
M3 = "0.15"
[road]
f = "0.5"
g = "9.81"
[force]
kind = "internal"
)";

MechanismScene read(const std::string& text) {
  return parse_scene(text, "some/where/scene.toml");
}

std::string with(std::string text, const std::string& old, const std::string& replacement) {
  const std::size_t place = text.find(old);
  REQUIRE(place != std::string::npos);
  return text.replace(place, old.size(), replacement);
}

Rational q(const char* text) {
  return parse_rational(text);
}

/// A parameter of the mechanism in a scene.
Rational value(const MechanismScene& scene, std::string_view symbol) {
  return scene.values.parameters[bicycle_parameter(symbol)];
}
bool has_J(const MechanismScene& scene) {
  return scene.values.given[bicycle_parameter("J")];
}
/// mu L/R.
Rational sigma(const MechanismScene& scene) {
  return value(scene, "r2") * value(scene, "L") / (value(scene, "r1") * value(scene, "R"));
}

std::vector<std::filesystem::path> cases() {
  std::vector<std::filesystem::path> result;
  for (const auto& entry : std::filesystem::directory_iterator(SLIPPROOF_SOURCE_DIR "/cases")) {
    if (entry.path().extension() == ".toml") result.push_back(entry.path());
  }
  return result;
}

}  // namespace

TEST_CASE("a scene in the paper's own parameters") {
  const MechanismScene scene = read(full_scene);
  CHECK(scene.name == "city bicycle");
  CHECK(value(scene, "R") == q("17/50"));
  CHECK(value(scene, "h") == q("71/100"));
  CHECK(value(scene, "b2") == q("9/20"));
  CHECK(value(scene, "b3") == q("3/5"));
  CHECK(value(scene, "I1") == q("1/100"));
  CHECK(value(scene, "I2") == q("3/25"));
  CHECK(value(scene, "I3") == q("3/25"));
  CHECK(value(scene, "r1") == q("9/100"));
  CHECK(value(scene, "r2") == q("9/200"));
  CHECK(value(scene, "L") == q("17/100"));
  CHECK(value(scene, "M") == 85);
  CHECK(value(scene, "J") == 12);
  CHECK(value(scene, "f") == q("4/5"));
  CHECK(value(scene, "g") == q("981/100"));
  CHECK(value(scene, "external") == 0);
  CHECK(scene.load == Rational(300));
  CHECK(scene.notes.empty());
}

TEST_CASE("what may be left out") {
  std::string text = full_scene;
  for (const char* line : {"name = \"city bicycle\"\n", "M = \"85\"\n", "J = \"12\"\n", "F = \"300\"\n"})
    text = with(text, line, "");
  const MechanismScene scene = read(text);
  CHECK(scene.name == "scene");
  CHECK(value(scene, "M") == 1);
  CHECK_FALSE(has_J(scene));
  CHECK(!scene.load);
}

TEST_CASE("the other way to write each parameter") {
  CHECK(value(read(with(full_scene, "h0 = \"1.05\"", "h = \"-0.1\"")), "h") == q("-1/10"));
  const MechanismScene equal = read(with(full_scene, "b2 = \"0.45\"\nb3 = \"0.60\"", "b = \"0.5\""));
  CHECK(value(equal, "b2") == q("1/2"));
  CHECK(value(equal, "b3") == q("1/2"));
  const MechanismScene geared = read(with(full_scene, "r1 = \"0.09\"\nr2 = \"0.045\"", "mu = \"0.5\""));
  CHECK(value(geared, "r1") == 1);
  CHECK(value(geared, "r2") == q("1/2"));
  CHECK(geared.notes.size() == 1);
  CHECK(sigma(geared) == sigma(read(full_scene)));
  CHECK(value(read(with(full_scene, "\"internal\"", "\"external\"")), "external") == 1);
  // P = F sigma, sigma = 0.5 0.17/0.34 = 1/4.
  CHECK(read(with(full_scene, "F = \"300\"", "P = \"75\"")).load == Rational(300));
  CHECK(value(read(with(full_scene, "b2 = \"0.45\"", "b2 = \"-0.45\"")), "b2") == q("-9/20"));
}

TEST_CASE("bare numbers count as the decimals that are written, not as binary64") {
  const MechanismScene scene = read(with(with(full_scene, "f = \"0.8\"", "f = 0.8"), "F = \"300\"", "F = -3_0.1e-400"));
  CHECK(value(scene, "f") == q("4/5"));
  CHECK(scene.load == q("-30.1e-400"));
}

TEST_CASE("the reduced form of section 3") {
  const MechanismScene scene = read(reduced_scene);
  CHECK(value(scene, "M") == 1);
  CHECK(value(scene, "r1") == value(scene, "r2"));
  CHECK(value(scene, "I1") + value(scene, "I2") == q("0.1") * q("0.16"));  // M2 R^2
  CHECK(value(scene, "I3") == q("0.15") * q("0.16"));
  CHECK(sigma(scene) == 1);
  CHECK(scene.notes.size() == 2);
  CHECK(read(std::string(reduced_scene) + "P = 3\n").load == Rational(3));
  CHECK(read(std::string(reduced_scene) + "F = 3\n").load == Rational(3));
  // What says the same again is not a contradiction.
  const MechanismScene again = read(with(reduced_scene, "M2", "M = 1\nr1 = 0.1\nr2 = 0.1\nL = 0.2\nM2"));
  CHECK(sigma(again) == q("1/2"));
  CHECK(value(read(with(reduced_scene, "M2", "mu = 1\nM2")), "r2") == 1);
}

TEST_CASE("what several parameters say may be varied in their place") {
  const MechanismScene scene = read(full_scene);
  std::map<std::string, Rational> values;
  for (const CombinedParameter& combined : scene.combined) {
    values[combined.symbol] = combined.value;
    for (const auto& [symbol, over] : combined.sets) {
      if (combined.symbol != "b") CHECK(over.at(combined.value) == value(scene, symbol));
    }
  }
  CHECK(values == std::map<std::string, Rational>{{"b", q("0.525")}, {"h0", q("1.05")}, {"mu", q("0.5")}});
}

TEST_CASE("a shipped scene, written as one of its mechanism, reads back as it was") {
  for (const auto& path : cases()) {
    CAPTURE(path.string());
    const MechanismScene scene = read_scene(path), again = read(to_toml(scene, "bicycle"));
    CHECK(again.name == scene.name);
    CHECK(again.values.parameters == scene.values.parameters);
    CHECK(again.values.given == scene.values.given);
    CHECK(again.load == scene.load);
    CHECK(is_bicycle(again.mechanism));
  }
}

TEST_CASE("shipped scenes: enough of them, each with its own name and a word on its numbers") {
  std::set<std::string> names;
  for (const auto& path : cases()) {
    CAPTURE(path.string());
    CHECK(names.insert(read_scene(path).name).second);
    const std::string text = read_text_file(path);
    CHECK(text.starts_with("# "));
    const std::string comment = text.substr(0, text.find("\nname"));
    CHECK((comment.find("hosen") != std::string::npos || comment.find("table 1") != std::string::npos));
  }
  CHECK(names.size() >= 12);
}

TEST_CASE("the benchmark bicycle's scenes are its published bodies, taken together") {
  // Meijaard et al. 2007, table 1: mass, distance before the rear contact, height, pitch inertia about its own centre
  // (the wheels' own does not count: in J they are point masses).
  struct Body {
    Rational m, x, y, I;
  };
  std::vector<Body> bodies{{2, 0, q("0.3"), 0},
                           {85, q("0.3"), q("0.9"), 11},
                           {4, q("0.9"), q("0.7"), q("0.06")},
                           {3, q("1.02"), q("0.35"), 0}};
  const auto check = [&bodies](const char* file) {
    Rational m = 0, mx = 0, my = 0, I = 0;
    for (const Body& body : bodies) {
      m += body.m;
      mx += body.m * body.x;
      my += body.m * body.y;
      I += body.I + body.m * (body.x * body.x + body.y * body.y);  // about the rear contact
    }
    const MechanismScene scene = read_scene(std::filesystem::path(SLIPPROOF_SOURCE_DIR "/cases") / file);
    const auto p = [&](std::string_view symbol) { return value(scene, symbol); };
    CAPTURE(file);
    CHECK(p("M") == m);
    CHECK(p("b2") == mx / m);
    CHECK(p("b2") + p("b3") == q("1.02"));
    CHECK(p("h") + p("R") == my / m);
    CHECK(p("J") == I - (mx * mx + my * my) / m);  // Huygens-Steiner
    CHECK(p("R") == q("0.3"));
    CHECK(p("I2") == q("0.12"));
    CHECK(p("I3") / (p("R") * p("R")) == q("0.28") / (q("0.35") * q("0.35")));
  };
  check("city-bicycle.toml");
  check("city-bicycle-on-ice.toml");
  check("frictionless.toml");
  bodies.push_back({25, q("-0.05"), q("0.55"), q("0.5")});
  check("touring-bicycle.toml");
}

TEST_CASE("mistakes carry the name of the file, and files that are none are refused") {
  try {
    parse_scene("R", "dir/x.toml");
    FAIL("accepted");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).starts_with("dir/x.toml:1:"));
  }
  CHECK_THROWS_AS(read_scene("/nonexistent/scene.toml"), InputError);
  CHECK_THROWS_AS(read_scene("/"), InputError);
}
