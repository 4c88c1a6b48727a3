// The bicycle is drawn as its mechanism's file says: wheels, chain, pedal, forces to scale; what its symbols mean where
// no motion is drawn.
#include <algorithm>
#include <map>
#include <set>

#include "base/number/binary64.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/write_mechanism.hpp"
#include "mechanics/scene/bicycle_scene.hpp"
#include "report/picture/drawn_mechanism.hpp"
#include "report/picture/motions_svg.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::string bicycles = SLIPPROOF_SOURCE_DIR "/cases/";

std::size_t count(const DrawnMechanism& picture, const std::string& path) {
  return picture.tree.select_nodes(path.c_str()).size();
}

Rational acceleration(const MotionAtLoad& motion, std::string_view symbol) {
  const auto names = acceleration_names(bicycle_mechanism());
  return motion.accelerations[static_cast<std::size_t>(std::find(names.begin(), names.end(), symbol) - names.begin())];
}

/// Symbols as they are in the picture, without values.
std::multiset<std::string> labels(const DrawnMechanism& picture) {
  std::multiset<std::string> all;
  for (const auto& found : picture.tree.select_nodes("//text")) {
    std::string label = all_text(found.node());
    label = label.substr(0, label.find_first_of("=\xe2"));  // = or a rounded value
    std::erase_if(label, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    all.insert(label);
  }
  return all;
}

}  // namespace

TEST_CASE("a wheel is apart from the road exactly where a motion takes it off the road") {
  // Three motions at one force: rolling, slipping, and the front wheel off the road.
  MechanismScene scene = read_scene(bicycles + "ambiguous.toml");
  const Rational own = *scene.load;
  std::map<std::string, bool> seen;
  for (const int external : {0, 1}) {
    scene.values.parameters[bicycle_parameter("external")] = external;
    for (const Rational& F : {Rational(-200), Rational(-3), own, Rational(200)}) {
      scene.load = F;
      for (const MotionAtLoad& motion : motions(scene).motions) {
        CAPTURE(name(motion.all_modes().front()));
        const DrawnMechanism picture = drawn(scene, &motion);
        const auto surfaces = picture.tree.select_nodes("//line[@class='frame']");
        const auto wheels = picture.tree.select_nodes("//circle[@class='body']");
        REQUIRE(surfaces.size() == 2);
        REQUIRE(wheels.size() == 2);
        std::string off;
        for (std::size_t i = 0; i < 2; ++i) {
          const auto wheel = wheels[i].node();
          const double lowest = wheel.attribute("cy").as_double() + wheel.attribute("r").as_double();
          const double road = surfaces[i].node().attribute("y1").as_double();
          const std::string gap = i == 0 ? "gap2" : "gap3";
          const bool lifts = acceleration(motion, gap) > 0;
          CHECK((road - lowest > 5) == lifts);
          if (!lifts) CHECK(road == doctest::Approx(lowest));
          CHECK(labels(picture).count(gap) == (lifts ? 1 : 0));
          if (lifts) off += gap;
        }
        seen[off] = true;
      }
    }
  }
  CHECK(seen.contains(""));
  CHECK(seen.contains("gap2"));
  CHECK(seen.contains("gap3"));
}

TEST_CASE("the shipped figures are what `slipproof draw` draws of their scenes") {
  CHECK(test::read_file(bicycles + "bicycle.svg") ==
        mechanism_svg_file(read_scene(bicycles + "city-bicycle.toml"), nullptr));
  const std::string three = bicycles + "three-motions/three-motions";
  const MechanismScene scene = read_scene(three + ".toml");
  CHECK(test::read_file(three + ".svg") == motions_svg_file(scene, motions(scene)));
}

TEST_CASE("without a motion the figure names every length, force and acceleration of the model, with a motion forces") {
  const MechanismScene scene = read_scene(bicycles + "city-bicycle.toml");
  const DrawnMechanism still = drawn(scene);
  check_readable(still);
  const auto named = labels(still);
  for (const char* symbol : {"R",  "h",  "h0", "b2", "b3", "r1", "r2", "L",  "F", "N2", "N3",
                             "S2", "S3", "a",  "M",  "C",  "O1", "O2", "O3", "x", "y",  "pedal"}) {
    CAPTURE(symbol);
    CHECK(std::ranges::count_if(named, [&](const std::string& label) {
            return label == symbol || (std::string_view(symbol) == "M" && label.starts_with("M"));
          }) == 1);
  }
  CHECK(count(still, "//line[@class='curve']") == 10);  // to what lengths measure
  const MotionAtLoad motion = motions(scene).motions.front();
  const DrawnMechanism moving = drawn(scene, &motion);
  check_readable(moving);
  CHECK(count(moving, "//line[@class='curve']") == 0);
  for (const char* symbol : {"F", "N2", "N3", "S2", "S3", "a"}) CHECK(labels(moving).count(symbol) == 1);
  for (const char* symbol : {"h0", "b2", "O1", "pedal"}) CHECK(labels(moving).count(symbol) == 0);
}

TEST_CASE("the pedal force starts at the pedal, L below the axles, and points backwards when positive") {
  MechanismScene scene = read_scene(bicycles + "city-bicycle.toml");
  for (const int sign : {1, -1}) {
    scene.load = Rational(300 * sign);
    const MotionAtLoad motion = motions(scene).motions.front();
    const DrawnMechanism picture = drawn(scene, &motion);
    const auto wheel = picture.tree.select_node("//circle[@class='body']").node();
    const double metre = wheel.attribute("r").as_double() / 0.3, axles = wheel.attribute("cy").as_double();
    int found = 0;
    for (const DrawnArrow& arrow : arrows(picture, "load")) {
      if (std::abs(arrow.dx) < 1) continue;  // the weight
      ++found;
      CHECK(arrow.from_y == doctest::Approx(axles + 0.17 * metre).epsilon(0.01));
      CHECK((arrow.dx < 0) == (sign > 0));
    }
    CHECK(found == 1);
    CHECK(count(picture, "//circle[@class='chain']") == 2);  // both sprockets
    CHECK(count(picture, "//path[@class='chain']") == 2);    // both runs
  }
}

TEST_CASE("the weight is to scale with the forces of the road, and a points where it is positive") {
  MechanismScene scene = read_scene(bicycles + "city-bicycle.toml");
  for (const int F : {300, -300}) {
    scene.load = F;
    const MotionAtLoad motion = motions(scene).motions.front();
    REQUIRE(acceleration(motion, "a_y").is_zero());
    const DrawnMechanism picture = drawn(scene, &motion);
    double up = 0, down = 0;
    for (const DrawnArrow& arrow : arrows(picture, "normal")) up -= arrow.dy;
    for (const DrawnArrow& arrow : arrows(picture, "load")) down += arrow.dy;
    CHECK(down > 20);
    CHECK(up == doctest::Approx(down).epsilon(0.01));
    const auto shown = arrows(picture, "acceleration");
    REQUIRE(shown.size() == 1);
    CHECK((shown[0].dx > 0) == (acceleration(motion, "a") > 0));
  }
}

TEST_CASE("a mechanism that is written and read again has the same picture") {
  MechanismScene scene = read_scene(bicycles + "city-bicycle.toml");
  const std::string picture = mechanism_svg_file(scene, nullptr);
  scene.mechanism = parse_mechanism(to_toml(scene.mechanism), "bicycle.toml");
  CHECK(mechanism_svg_file(scene, nullptr) == picture);
}
