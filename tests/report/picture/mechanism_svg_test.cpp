// Pictures of mechanisms: coordinates by hand, forces as long as they are large, nothing outside and no label over
// another.
#include "report/picture/mechanism_svg.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <pugixml.hpp>

#include "base/input/diagnostic.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "report/markup/element.hpp"
#include "report/picture/drawn_mechanism.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

MechanismScene scene_of(const std::string& contacts_and_shapes, const Rational& b) {
  MechanismScene scene;
  scene.name = "<&> \x01";
  scene.mechanism = parse_mechanism(
      "schema = \"slipproof/mechanism/1\"\nname = \"sled\"\n[parameters]\nb = \"real\"\n[load]\nsymbol = \"F\"\n"
      "[unknowns]\naccelerations = [\"ax\", \"ay\"]\n[motion]\nax = \"ax = F\"\nay = \"ay = -2\"\n" +
          contacts_and_shapes,
      "sled.toml");
  scene.values = default_values(scene.mechanism);
  scene.values.parameters[0] = b;
  scene.load = Rational(-1);
  return scene;
}

const std::string runner = "[[contact]]\nname = \"runner\"\ngap = \"ay\"\nslip = \"ax\"\nfriction = \"1\"\n";

}  // namespace

TEST_CASE("the polygon of a block stands where its file says, to scale and y up") {
  const MechanismScene scene = read_scene(drawn_scenes + "block-shaken.toml");  // b = 1/2, h = 1
  const DrawnMechanism picture = drawn(scene);
  // Corners (-b, -h), (b, -h), (b, h), (-b, h); an arrow below reaches down to -5/4 h, so that all is 9/4 high.
  const double scale = std::min(270 / 1.0, 220 / 2.25);
  const auto corners = numbers(picture.tree.select_node("//path[@class='body']").node().attribute("d").value());
  REQUIRE(corners.size() == 8);
  CHECK(corners[2] - corners[0] == doctest::Approx(1 * scale).epsilon(1e-3));
  CHECK(corners[3] == corners[1]);
  CHECK(corners[4] == corners[2]);
  CHECK(corners[3] - corners[5] == doctest::Approx(2 * scale).epsilon(1e-3));  // up in the file is up in the picture
  CHECK(corners[7] == corners[5]);
  const auto contacts = picture.tree.select_nodes("//circle[@r='3']");
  REQUIRE(contacts.size() == 2);
  CHECK(contacts[0].node().attribute("cx").as_double() == corners[0]);
  CHECK(contacts[1].node().attribute("cy").as_double() == corners[3]);
}

TEST_CASE("forces are drawn in proportion, where they act and with their sign") {
  const MechanismScene scene = scene_of(runner + "at = [\"b\", \"1\"]\ndirection = [\"0\", \"3\"]\n", 2);
  const MotionsAtLoad found = motions(scene);
  REQUIRE(found.motions.size() == 1);  // N = 2, and it sticks with S = 1 against F = -1
  const DrawnMechanism picture = drawn(scene, &found.motions[0]);
  const auto normal = arrows(picture, "normal"), friction = arrows(picture, "friction");
  REQUIRE(normal.size() == 1);
  REQUIRE(friction.size() == 1);
  CHECK(normal[0].dx == doctest::Approx(0));
  CHECK(normal[0].dy < 0);  // up, and it ends below the contact
  CHECK(normal[0].from_y > 0);
  CHECK(friction[0].dx > 0);
  CHECK(normal[0].length() == doctest::Approx(2 * friction[0].length()).epsilon(1e-3));
  const std::string text = all_text(picture.tree.document_element());
  for (const char* expected : {"runner: stick", "= 2", "= 1", "F = −1"}) {
    CAPTURE(expected);
    CHECK(text.find(expected) != text.npos);
  }
  check_readable(picture);

  const MechanismScene turned =
      scene_of(runner + "at = [\"b\", \"1\"]\ndirection = [\"0\", \"1\"]\nslip_direction = [\"-1\", \"0\"]\n", 2);
  CHECK(arrows(drawn(turned, &found.motions[0]), "friction")[0].dx < 0);
  const MechanismScene wall = scene_of(runner + "at = [\"b\", \"1\"]\ndirection = [\"-1\", \"0\"]\n", 2);
  const DrawnMechanism beside = drawn(wall, &found.motions[0]);
  CHECK(arrows(beside, "normal")[0].dx < 0);
  CHECK(arrows(beside, "friction")[0].dy < 0);  // up
}

TEST_CASE("what a guide pulls is drawn away from the body") {
  const MechanismScene scene =
      scene_of(runner + "bilateral = true\nat = [\"0\", \"0\"]\ndirection = [\"0\", \"-1\"]\n", 0);
  const MotionsAtLoad found = motions(scene);  // gravity and N act along the same line: N = 2, downwards
  REQUIRE(!found.motions.empty());
  const auto pushed = arrows(drawn(scene, &found.motions[0]), "normal");
  REQUIRE(pushed.size() == 1);
  CHECK(pushed[0].dy > 0);
  CHECK(pushed[0].from_y < 0);
  MotionAtLoad pulled = found.motions[0];
  for (Range& force : pulled.forces) force = {Rational(-2), Rational(-2)};
  const auto away = arrows(drawn(scene, &pulled), "normal");
  CHECK(away[0].dy < 0);
  CHECK(away[0].from_y + away[0].dy < -10);
  CHECK(std::abs(away[0].from_y) < 10);
}

TEST_CASE("undetermined forces are dashed, with their ranges") {
  const MechanismScene scene = read_scene(drawn_scenes + "ladder.toml");
  const MotionsAtLoad found = motions(scene);
  REQUIRE(found.motions.size() == 1);
  const DrawnMechanism picture = drawn(scene, &found.motions[0]);
  for (const auto& arrow : arrows(picture, "normal")) CHECK(arrow.dashed);
  CHECK(all_text(picture.tree.document_element()).find("in ≈ [") != std::string::npos);
  MotionAtLoad determined = found.motions[0];
  for (Range& force : determined.forces) force = {Rational(3), Rational(3)};
  for (const auto& arrow : arrows(drawn(scene, &determined), "normal")) CHECK_FALSE(arrow.dashed);
}

TEST_CASE("every shipped mechanism has a picture, alone and with each motion, in which all can be read") {
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(drawn_scenes)) {
    CAPTURE(entry.path());
    const MechanismScene scene = read_scene(entry.path());
    CHECK(has_picture(scene.mechanism));
    check_readable(drawn(scene));
    ++pictures;
    if (scene.mechanism.load && !scene.load) continue;
    for (const MotionAtLoad& motion : motions(scene).motions) {
      const DrawnMechanism picture = drawn(scene, &motion);
      check_readable(picture);
      CHECK(!all_text(picture.tree.document_element().child("title")).empty());
      CHECK(all_text(picture.tree.document_element().child("desc")).find(scene.mechanism.contacts[0].name) == 0);
      ++pictures;
    }
  }
  CHECK(pictures >= 28);
}

TEST_CASE("scenes of bodies that people ask about can be read, for every kind of motion that they have") {
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/asked/scenes")) {
    CAPTURE(entry.path());
    MechanismScene scene = read_scene(entry.path());
    check_readable(drawn(scene));
    const FrictionProblem problem = friction_problem(scene.mechanism, scene.values);
    for (const LoadCell& cell : cells_of(problem, ModeSolver(problem, std::nullopt).consistent())) {
      scene.load = cell.loads.sample();
      for (const MotionAtLoad& motion : motions(scene).motions) {
        CAPTURE(scene.load->str());
        check_readable(drawn(scene, &motion));
        ++pictures;
      }
    }
  }
  CHECK(pictures >= 50);
}

TEST_CASE("what pushes a body is drawn where it acts, to scale beside the contact forces") {
  MechanismScene scene = read_scene(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/asked/scenes/block-pushed.toml");
  const auto alone = arrows(drawn(scene), "load");
  REQUIRE(alone.size() == 1);
  CHECK(alone[0].dx > 0);
  CHECK(alone[0].dy == doctest::Approx(0));
  scene.load = Rational(1, 4);
  const MotionAtLoad motion = motions(scene).motions.at(0);
  const DrawnMechanism picture = drawn(scene, &motion);
  const auto load = arrows(picture, "load"), normal = arrows(picture, "normal");
  REQUIRE(load.size() == 1);
  REQUIRE(normal.size() == 2);
  const double weight =
      std::max(normal[0].length(), normal[1].length()) + std::min(normal[0].length(), normal[1].length());
  CHECK(load[0].length() == doctest::Approx(std::max(weight / 4, 12.0)).epsilon(0.2));
}

TEST_CASE("numbers of one picture are all fractions or all decimals") {
  const auto point = [](const Rational& x) { return Range{x, x}; };
  const NumberWords fractions({point(Rational(1, 3)), point(Rational(-5))});
  CHECK(fractions.value(Rational(1, 3)) == "= 1/3");
  CHECK(fractions.range({Rational(0), Rational(5, 2)}) == "in [0, 5/2]");
  const NumberWords decimals({point(Rational(1, 3)), point(Rational(12345, 67890123))});  // the second is long
  CHECK(decimals.value(Rational(1, 3)) == "≈ 0.3333");
  CHECK(decimals.value(Rational(3, 4)) == "= 0.75");
  CHECK(decimals.value(Rational(-5)) == "= −5");
  CHECK(decimals.range({Rational(0), Rational(5, 2)}) == "in [0, 2.5]");
  CHECK(decimals.range({Rational(-1, 3), {}}) == "in ≈ [−0.333, ∞)");
}

TEST_CASE("what has no place is told, and a mechanism without any place has no picture") {
  const MechanismScene nowhere = scene_of(runner, 1);
  CHECK_FALSE(has_picture(nowhere.mechanism));
  try {
    mechanism_svg_file(nowhere, nullptr);
    CHECK(false);
  } catch (const InputError& error) {
    CHECK(std::string(error.what()) ==
          "sled.toml: the mechanism sled has no picture, expected a [[shape]], or a contact that says where it is with "
          "`at`");
  }
  const MechanismScene shape = scene_of(runner + "[[shape]]\nkind = \"point\"\npoints = [[\"b\", \"0\"]]\n", 1);
  CHECK(all_text(drawn(shape).tree.document_element()).find("runner (has no place)") != std::string::npos);
  const MotionsAtLoad found = motions(shape);
  CHECK(all_text(drawn(shape, &found.motions[0]).tree.document_element()).find("N_runner = 2") != std::string::npos);
}

TEST_CASE("a coordinate without a value is refused at its place") {
  const MechanismScene scene = scene_of(runner + "at = [\"1/b\", \"0\"]\n", 0);
  try {
    mechanism_svg_file(scene, nullptr);
    CHECK(false);
  } catch (const InputError& error) {
    CHECK(error.diagnostics()[0].line > 0);
    CHECK(error.diagnostics()[0].message == "found '1/b', expected a coordinate that has a value there");
  }
}

TEST_CASE("inside of a page the same picture has a title and a description") {
  const ElementTree document("div");
  const MechanismScene scene = read_scene(drawn_scenes + "gripper.toml");
  add_mechanism(document.root(), scene, nullptr, "A gripper");
  pugi::xml_document tree;
  REQUIRE(tree.load_string(document.xml().c_str()));
  const auto svg = tree.child("div").child("svg");
  CHECK(std::string(svg.attribute("role").value()) == "img");
  CHECK(std::string(svg.child_value("title")) == "A gripper");
  CHECK(std::string(svg.child_value("desc")) == "left; right; pushed by F; pushed by F; F = 30 N.");
  CHECK(svg.attribute("viewBox"));
}
