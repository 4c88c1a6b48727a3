// What pictures of mechanisms show of forces: they are to scale and add up, slopes slope, what opens is apart, labels
// are at their own arrows, and many contacts have letters.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"
#include "mechanics/bodies/bodies.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "report/picture/drawn_mechanism.hpp"
#include "report/picture/labels/contact_table.hpp"
#include "report/picture/motions_svg.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::string shipped_files = SLIPPROOF_SOURCE_DIR "/cases/";

MechanismScene engine_scene(const std::string& name) {
  return read_scene(shipped_files + "engines/scenes/" + name + ".toml");
}

std::vector<DrawnArrow> all_arrows(const DrawnMechanism& picture) {
  std::vector<DrawnArrow> all;
  for (const char* css : {"normal", "friction", "load", "load weight"}) {
    for (const DrawnArrow& arrow : arrows(picture, css)) all.push_back(arrow);
  }
  return all;
}

double number(const MechanismScene& scene, const ProblemMaker& maker, const PlacedExpression& placed) {
  auto at = maker.at(scene.values);
  if (scene.load) at.set(maker.compiled().load(), *scene.load);
  return nearest_binary64(*at.number(maker.compiled().compile(placed.expression)).number);
}

double acceleration(const MechanismScene& scene, const MotionAtLoad& motion, const Body::Unknown& unknown) {
  const auto names = acceleration_names(scene.mechanism);
  const auto at = static_cast<std::size_t>(std::ranges::find(names, unknown.symbol) - names.begin());
  return (unknown.negated ? -1 : 1) * nearest_binary64(motion.accelerations.at(at));
}

double distance(const TextBox& box, double x, double y) {
  return std::hypot(std::max({box.left - x, x - box.right, 0.0}), std::max({box.top - y, y - box.bottom, 0.0}));
}
double distance(const TextBox& box, const DrawnArrow& arrow) {
  double least = std::numeric_limits<double>::max();
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    least = std::min(least, distance(box, arrow.from_x + part * arrow.dx, arrow.from_y + part * arrow.dy));
  }
  return least;
}

}  // namespace

TEST_CASE("of one body all drawn forces add up to its mass times its acceleration, on slopes too") {
  int compared = 0, sloping = 0;
  for (const auto& entry : std::filesystem::directory_iterator(shipped_files + "engines/scenes/one-motion")) {
    CAPTURE(entry.path());
    const MechanismScene scene = read_scene(entry.path());
    const Bodies& bodies = *scene.mechanism.bodies;
    if (bodies.bodies.size() != 2 || !bodies.bodies[1].mass || !bodies.joints.empty() || !bodies.gravity) continue;
    if (scene.mechanism.contacts.size() >= fewest_lettered) continue;
    const MotionAtLoad motion = motions(scene).motions.at(0);
    if (std::ranges::any_of(motion.forces, [](const Range& force) { return !force.is_point(); })) continue;
    double right = 0, down = 0, unit = 0;
    for (const DrawnArrow& arrow : all_arrows(drawn(scene, &motion))) right += arrow.dx, down += arrow.dy;
    unit = 72 / largest_force(scene, motion);
    const ProblemMaker maker(scene.mechanism);
    const double m = number(scene, maker, bodies.bodies[1].mass);
    const double gx = number(scene, maker, bodies.gravity.x), gy = number(scene, maker, bodies.gravity.y);
    const double ax = acceleration(scene, motion, bodies.bodies[1].unknowns[0]);
    const double ay = acceleration(scene, motion, bodies.bodies[1].unknowns[1]);
    constexpr double shorter_than_a_pixel = 2.5;
    CHECK(down ==
          doctest::Approx(unit * m * (ax * gx + ay * gy) / std::hypot(gx, gy)).epsilon(shorter_than_a_pixel / 72));
    CHECK(std::abs(std::hypot(right, down) - unit * m * std::hypot(ax, ay)) < shorter_than_a_pixel);
    ++compared;
    sloping += gx != 0 ? 1 : 0;
  }
  CHECK(compared >= 40);
  CHECK(sloping >= 5);
}

TEST_CASE("arrows of contact forces are as long as the forces are large, whatever else there is") {
  int small = 0;
  for (const char* name : {"one-motion/car-climbs", "one-motion/plank-rolls", "one-motion/crate-rides-on-sledge"}) {
    const MechanismScene scene = engine_scene(name);
    const MotionAtLoad motion = motions(scene).motions.at(0);
    const double unit = 72 / largest_force(scene, motion);
    std::vector<double> expected, lengths;
    for (const MechanismContact& contact : scene.mechanism.contacts) {
      for (const std::size_t force : {contact.normal, *contact.tangent}) {
        const Range& range = range_of_force(scene, motion, force);
        const double size = std::abs(nearest_binary64(Rational((*range.lower + *range.upper) / 2))) * unit;
        if (size >= 1) expected.push_back(size);
        small += size > 0 && size < 10 ? 1 : 0;
      }
    }
    const DrawnMechanism picture = drawn(scene, &motion);
    for (const char* css : {"normal", "friction"}) {
      for (const DrawnArrow& arrow : arrows(picture, css)) lengths.push_back(arrow.length());
    }
    std::ranges::sort(expected), std::ranges::sort(lengths);
    REQUIRE(lengths.size() == expected.size());
    for (std::size_t i = 0; i < lengths.size(); ++i) CHECK(lengths[i] == doctest::Approx(expected[i]).epsilon(0.01));
  }
  CHECK(small > 0);
}

TEST_CASE("gravity that leans in the file points down in the picture") {
  for (const char* name :
       {"one-motion/cube-slides-down-slope", "one-motion/car-climbs", "one-motion/ball-rolls-down-slope"}) {
    CAPTURE(name);
    const MechanismScene scene = engine_scene(name);
    const MotionAtLoad motion = motions(scene).motions.at(0);
    const DrawnMechanism picture = drawn(scene, &motion);
    const auto surface = picture.tree.select_node("//line[@class='frame']").node();
    CHECK(std::abs(surface.attribute("y1").as_double() - surface.attribute("y2").as_double()) > 5);
    const auto load = arrows(picture, "load weight");
    CHECK(std::ranges::any_of(load, [](const DrawnArrow& a) { return std::abs(a.dx) < 0.01 && a.dy > 5; }));
    CHECK(all_text(picture.tree.document_element().child("desc")).find("so that gravity points down") !=
          std::string::npos);
    check_readable(picture);
  }
}

TEST_CASE("a load of a file with equations has an arrow to scale, and none where it is 0") {
  MechanismScene scene = read_scene(drawn_scenes + "stacked-blocks.toml");
  const auto length = [&](const Rational& load) {
    scene.load = load;
    const MotionAtLoad motion = motions(scene).motions.at(0);
    const auto found = arrows(drawn(scene, &motion), "load");
    return found.empty() ? 0.0 : found[0].dx * largest_force(scene, motion);
  };
  CHECK(length(0) == 0);
  CHECK(length(2) == doctest::Approx(72 * 2.0).epsilon(0.01));
  CHECK(length(-2) == doctest::Approx(-72 * 2.0).epsilon(0.01));
}

TEST_CASE("a load beyond all doubles has an arrow in its direction, and its size in words") {
  for (const std::string name : {"city-bicycle.toml", "mechanisms/asked/scenes/block-pushed.toml"}) {
    CAPTURE(name);
    MechanismScene scene = read_scene(shipped_files + name);
    scene.load = parse_rational("1e400");
    for (const MotionAtLoad& motion : motions(scene).motions) {
      const std::string svg = mechanism_svg_file(scene, &motion);
      for (const char* no_number : {"nan", "inf"}) CHECK(svg.find(no_number) == svg.npos);
      CHECK(svg.find("1e+400") != svg.npos);
      CHECK(!arrows(drawn(scene, &motion), "load").empty());
    }
  }
}

TEST_CASE("where a contact opens, its surface is apart from the body") {
  MechanismScene scene = read_scene(shipped_files + "mechanisms/asked/scenes/block-pushed.toml");
  scene.load = Rational(1, 3);
  for (const MotionAtLoad& motion : motions(scene).motions) {
    const DrawnMechanism picture = drawn(scene, &motion);
    const auto marks = picture.tree.select_nodes("//circle[@r='3']"),
               lines = picture.tree.select_nodes("//line[@class='frame']");
    REQUIRE(marks.size() == 2);
    REQUIRE(lines.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
      const double apart = lines[i].node().attribute("y1").as_double() - marks[i].node().attribute("cy").as_double();
      CHECK((apart > 5) == (common_state(motion, i) == "lift"));
    }
  }
}

TEST_CASE("pictures of several motions have one viewBox: what does not move is in the same place") {
  const MechanismScene scene = read_scene(shipped_files + "ambiguous.toml");
  pugi::xml_document tree;
  REQUIRE(tree.load_string(motions_svg_file(scene, motions(scene)).c_str()));
  std::set<std::string> boxes, wheels;
  const auto pictures = tree.select_nodes("//svg[@class='mechanism']");
  REQUIRE(pictures.size() == 3);
  for (const auto& picture : pictures) {
    boxes.insert(picture.node().attribute("viewBox").value());
    const auto wheel = picture.node().select_node(".//circle[@class='body']").node();
    wheels.insert(std::string(wheel.attribute("cx").value()) + " " + wheel.attribute("cy").value());
  }
  CHECK(boxes.size() == 1);
  CHECK(wheels.size() == 1);
}

TEST_CASE("a contact that slides says where to, and a body how it moves") {
  const MechanismScene scene = engine_scene("several-or-none/painleve-rod-ambiguous");
  for (const MotionAtLoad& motion : motions(scene).motions) {
    const auto moves = arrows(drawn(scene, &motion), "moves");
    REQUIRE(moves.size() >= 2);  // of the tip and of the rod's centre; the spin is a circle
    CHECK(std::abs(moves[0].dx) > 10);
    CHECK((moves[0].dx > 0) == (scene.values.starts[0] == ElementKind::Start::slides_forward));
  }
}

TEST_CASE("the label of a normal force is nearer to its own arrow than to any other") {
  for (const std::string name :
       {"mechanisms/asked/scenes/stepladder", "engines/scenes/one-motion/plank-rolls",
        "engines/scenes/one-motion/stepladder-slides", "engines/scenes/one-motion/car-climbs"}) {
    CAPTURE(name);
    MechanismScene scene = read_scene(shipped_files + name + ".toml");
    if (scene.mechanism.load && !scene.load) scene.load = Rational(0);
    const MotionAtLoad motion = drawn_motions(motions(scene)).at(0);
    const DrawnMechanism picture = drawn(scene, &motion);
    const auto normals = arrows(picture, "normal");
    std::vector<std::string> pushing;
    for (const MechanismContact& contact : scene.mechanism.contacts) pushing.push_back(contact.name);
    REQUIRE(normals.size() == pushing.size());
    for (const TextBox& box : text_boxes(picture)) {
      for (std::size_t own = 0; own < pushing.size(); ++own) {
        if (!box.words.starts_with("N" + pushing[own])) continue;
        CAPTURE(box.words);
        for (const DrawnArrow& other : normals) {
          CHECK(distance(box, normals[own]) <= distance(box, other) + 1e-6);
        }
      }
    }
  }
}

TEST_CASE("from eight contacts on letters stand at the contacts, and a table says what they are") {
  for (const char* name : {"beam-on-24-feet", "hand-of-12-fingers", "ten-blocks"}) {
    CAPTURE(name);
    MechanismScene scene = read_scene(shipped_files + "mechanisms/many/scenes/" + name + ".toml");
    if (!scene.load) scene.load = Rational(0);
    const MotionAtLoad motion = drawn_motions(motions(scene)).at(0);
    const DrawnMechanism picture = drawn(scene, &motion);
    check_readable(picture);
    std::map<std::string, int> letters;
    std::size_t named = 0;
    for (const TextBox& box : text_boxes(picture)) {
      if (box.words.size() <= 2) ++letters[box.words];
      for (const MechanismContact& contact : scene.mechanism.contacts)
        named += box.words == contact.name + ": stick" ? 1 : 0;
    }
    CHECK(named == scene.mechanism.contacts.size());
    for (std::size_t i = 0; i < scene.mechanism.contacts.size(); ++i) {
      CHECK(letters[contact_letter(i)] == 2);  // in the drawing, and in the table
    }
  }
  CHECK(contact_letter(25) == "z");
  CHECK(contact_letter(26) == "aa");
  CHECK(contact_letter(51) == "az");
}

TEST_CASE("no sprocket of a shipped scene is larger than the wheels") {
  int bicycles = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shipped_files + "engines/scenes")) {
    if (entry.path().filename().string().find("bicycle") == std::string::npos) continue;
    CAPTURE(entry.path());
    const MechanismScene scene = read_scene(entry.path());
    std::map<std::string, Rational> values;
    for (std::size_t i = 0; i < scene.mechanism.parameters.size(); ++i) {
      values[scene.mechanism.parameters[i].symbol] = scene.values.parameters[i];
    }
    CHECK(values.at("r1") < values.at("R"));
    CHECK(values.at("r2") < values.at("R"));
    ++bicycles;
  }
  CHECK(bicycles >= 2);
}
