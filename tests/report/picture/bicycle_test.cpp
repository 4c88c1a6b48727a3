// The small picture of a bicycle: wheels on the road touch it, one that leaves the road is above it.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "mechanics/scene/bicycle_scene.hpp"
#include "report/markup/element.hpp"
#include "report/picture/bicycle_figure.hpp"
#include "report/picture/bicycle_svg.hpp"
#include "support/run_program.hpp"

using namespace slipproof;

namespace {

struct DrawnBicycle {
  double road = 0;
  std::vector<double> lowest;  ///< of each wheel, rear first
  std::size_t traces = 0;
  std::string label, text;
};

DrawnBicycle draw(const MechanismScene& scene, const MotionAtLoad* motion) {
  const ElementTree document("svg");
  add_bicycle(document.root(), scene, motion, "A bicycle");
  pugi::xml_document tree;
  REQUIRE(tree.load_string(document.xml().c_str()));
  DrawnBicycle drawn;
  drawn.road = tree.select_node("//line[@class='frame']").node().attribute("y1").as_double();
  for (const auto& found : tree.select_nodes("//circle[@class='body']")) {
    drawn.lowest.push_back(found.node().attribute("cy").as_double() + found.node().attribute("r").as_double());
  }
  drawn.traces = tree.select_nodes("//circle[@class='curve']").size();
  drawn.label = tree.select_node("//svg[@class='bicycle']").node().attribute("aria-label").value();
  for (const auto& found : tree.select_nodes("//text//text()")) drawn.text += found.node().value();
  return drawn;
}

std::vector<MotionAtLoad> motions_at_load(const MechanismScene& scene) {
  return motions_of(friction_problem(scene.mechanism, scene.values), scene.load).motions;
}

Rational acceleration(const MotionAtLoad& motion, std::string_view symbol) {
  const auto names = acceleration_names(bicycle_mechanism());
  return motion.accelerations[static_cast<std::size_t>(std::find(names.begin(), names.end(), symbol) - names.begin())];
}

}  // namespace

TEST_CASE("a wheel is raised exactly where a motion takes it off the road") {
  // Three motions at one force: rolling, slipping, and the front wheel off the road.
  MechanismScene scene = read_scene(SLIPPROOF_SOURCE_DIR "/cases/ambiguous.toml");
  const Rational own = *scene.load;
  std::map<std::string, bool> seen;
  for (const int external : {0, 1}) {
    scene.values.parameters[bicycle_parameter("external")] = external;
    for (const Rational& F : {Rational(-200), Rational(-3), own, Rational(200)}) {
      scene.load = F;
      for (const MotionAtLoad& motion : motions_at_load(scene)) {
        const bool rear = acceleration(motion, "gap2") > 0, front = acceleration(motion, "gap3") > 0;
        const DrawnBicycle drawn = draw(scene, &motion);
        REQUIRE(drawn.lowest.size() == 2);
        CAPTURE(name(motion.all_modes().front()));
        CHECK((drawn.lowest[0] < drawn.road - 8) == rear);
        CHECK((drawn.lowest[1] < drawn.road - 8) == front);
        if (!rear) CHECK(drawn.lowest[0] == doctest::Approx(drawn.road));
        if (!front) CHECK(drawn.lowest[1] == doctest::Approx(drawn.road));
        CHECK(drawn.traces == std::size_t{rear} + std::size_t{front});
        CHECK((drawn.label.find("raised") != drawn.label.npos) == (rear || front));
        CHECK((drawn.text.find("gap") != drawn.text.npos) == (rear || front));
        seen[std::string(rear ? "rear " : "") + (front ? "front" : "")] = true;
      }
    }
  }
  CHECK(seen.contains(""));
  CHECK(seen.contains("front"));
  CHECK(seen.contains("rear "));
}

TEST_CASE("without a motion both wheels stand on the road") {
  const DrawnBicycle drawn = draw(read_scene(SLIPPROOF_SOURCE_DIR "/cases/penny-farthing.toml"), nullptr);
  REQUIRE(drawn.lowest.size() == 2);
  for (const double lowest : drawn.lowest) CHECK(lowest == doctest::Approx(drawn.road));
  CHECK(drawn.label == "A bicycle");
}

TEST_CASE("the shipped figure is what `slipproof draw cases/city-bicycle.toml` draws") {
  const std::string cases = SLIPPROOF_SOURCE_DIR "/cases/";
  CHECK(test::read_file(cases + "bicycle.svg") == bicycle_figure_file(read_scene(cases + "city-bicycle.toml")));
}

TEST_CASE("the figure names every length, force and acceleration of the model") {
  pugi::xml_document tree;
  REQUIRE(tree.load_string(bicycle_figure_file(read_scene(SLIPPROOF_SOURCE_DIR "/cases/city-bicycle.toml")).c_str()));
  std::multiset<std::string> labels;
  for (const auto& found : tree.select_nodes("//text")) {
    std::string label;
    for (const auto& part : found.node().select_nodes(".//text()")) label += part.node().value();
    std::erase_if(label, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    labels.insert(label);
  }
  for (const char* symbol : {"R",  "h",  "h0", "b2", "b3", "r1", "r2", "L", "F", "N2",    "N3",
                             "S2", "S3", "a",  "C",  "O1", "O2", "O3", "x", "y", "chain", "pedal"}) {
    CAPTURE(symbol);
    CHECK(labels.count(symbol) == 1);
  }
}

TEST_CASE("the pedal force starts at the pedal, L below the axles, and points backwards when positive") {
  const MechanismScene scene = read_scene(SLIPPROOF_SOURCE_DIR "/cases/city-bicycle.toml");
  const MotionAtLoad motion = motions_at_load(scene).front();
  const ElementTree document("svg");
  add_bicycle(document.root(), scene, &motion, "A bicycle");
  pugi::xml_document tree;
  REQUIRE(tree.load_string(document.xml().c_str()));
  const auto wheel = tree.select_node("//circle[@class='body']").node();
  const double metre = wheel.attribute("r").as_double() / 0.3, axles = wheel.attribute("cy").as_double();
  bool found = false;
  for (const auto& arrow : tree.select_nodes("//g[@class='load']/line")) {
    const auto line = arrow.node();
    if (line.attribute("y1").as_double() != line.attribute("y2").as_double()) continue;  // the weight
    found = true;
    CHECK(line.attribute("y1").as_double() == doctest::Approx(axles + 0.17 * metre).epsilon(0.01));
    CHECK(line.attribute("x2").as_double() < line.attribute("x1").as_double());
  }
  CHECK(found);
  CHECK(tree.select_nodes("//circle[@class='chain']").size() == 2);  // both sprockets
  CHECK(tree.select_nodes("//line[@class='chain']").size() == 2);    // both runs
}
