// Scenes of the three formats as mechanisms in space: what is written, and what is told.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/input/diagnostic.hpp"
#include "contact/exchange/shapes/pairs.hpp"
#include "contact/exchange/space_mechanism.hpp"
#include "contact/imported/read_scene.hpp"
#include "mechanics/bodies/bodies.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "support/parsers.hpp"

using namespace slipproof;
using imported::Shape;
using imported::Vector;

namespace {

struct Imported {
  Mechanism mechanism;
  std::string text, told;

  std::size_t bodies() const { return mechanism.bodies->bodies.size() - 1; }
  std::size_t count(const std::string& kind) const {
    const std::string line = "kind = \"" + kind + "\"";
    std::size_t found = 0;
    for (std::size_t at = text.find(line); at != std::string::npos; at = text.find(line, at + 1)) ++found;
    return found;
  }
  bool tells(const std::string& what) const { return told.find(what) != std::string::npos; }
};

Imported import_text(const std::string& text, const imported::SpaceOptions& options = {},
                     const imported::ReadOptions& reading = {}, const std::string& file = "scene.xml") {
  const imported::SpaceMechanism found = to_space(imported::parse_scene_of_bodies(text, file, reading), options);
  Imported result{parse_mechanism(found.text, "imported"), found.text, {}};
  for (const std::string& one : found.import_notes) result.told += one + "\n";
  CAPTURE(result.told);
  CHECK(result.mechanism.contacts.size() >= found.contacts);
  return result;
}

std::string refusal(const std::string& text, const imported::SpaceOptions& options = {},
                    const imported::ReadOptions& reading = {}) {
  try {
    import_text(text, options, reading);
    return "read";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string mjcf_of(const std::string& world, const std::string& more = {}) {
  return "<mujoco model=\"m\"><worldbody><geom name=\"floor\" type=\"plane\" size=\"1 1 1\"/>" + world +
         "</worldbody>" + more + "</mujoco>";
}
std::string free_body(const std::string& name, const std::string& at, const std::string& geom) {
  return fmt::format("<body name=\"{0}\" pos=\"{1}\"><freejoint/><geom name=\"{0}_shape\" mass=\"1\" {2}/></body>",
                     name, at, geom);
}

std::vector<imported::TouchPoint> points_of(const Shape& a, const Shape& b, std::string* why = nullptr) {
  std::string said;
  const Rational touch(1, 10000);
  const auto found = touching(imported::solid_of(a), imported::solid_of(b), touch, said);
  if (why != nullptr) *why = said;
  return found;
}

Shape box(const Vector& at, const Vector& half) {
  Shape shape;
  shape.pose.at = at;
  shape.half = half;
  return shape;
}

}  // namespace

TEST_CASE("edges that cross touch in one point, with a normal across both") {
  Shape lower = box({0, 0, 0}, {5, 1, 1}), upper = box({0, 0, 0}, {1, 5, 1});
  // Each turned by 45 degrees about its length: an edge is up, and one is down, at the root of 2.
  lower.pose.turn = imported::rational_turn({0.92387953251128674, 0.38268343236508978, 0, 0}).turn;
  upper.pose.turn = imported::rational_turn({0.92387953251128674, 0, 0.38268343236508978, 0}).turn;
  upper.pose.at.z = Rational(282842712474619, 100000000000000);
  const auto found = points_of(upper, lower);
  REQUIRE(found.size() == 1);
  CHECK(abs(found[0].at.x) < Rational(1, 1000000));
  CHECK(abs(found[0].at.y) < Rational(1, 1000000));
  CHECK(abs(found[0].normal.z - 1) < Rational(1, 1000000));
  CHECK(dot(found[0].normal, found[0].normal) == 1);
  upper.pose.at.z += Rational(1, 1000);
  CHECK(points_of(upper, lower).empty());
  upper.pose.at.z = 2;
  std::string why;
  CHECK(points_of(upper, lower, &why).empty());
  CHECK(why.find("inside each other") != std::string::npos);
}

TEST_CASE("a hull of the corners of a box touches where the box does") {
  const Shape lower = box({0, 0, 0}, {2, 2, 1}), upper = box({1, 1, 2}, {2, 2, 1});
  Shape hull = box({1, 1, 2}, {});
  hull.kind = Shape::Kind::hull;
  for (int bits = 0; bits < 8; ++bits) {
    hull.points.push_back({(bits & 1) != 0 ? 2 : -2, (bits & 2) != 0 ? 2 : -2, (bits & 4) != 0 ? 1 : -1});
  }
  hull.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
  CHECK(imported::polytope_of(hull).sides.size() == 6);
  CHECK(imported::polytope_of(hull).edges.size() == 12);
  const auto expected = points_of(upper, lower), found = points_of(hull, lower);
  CHECK(expected.size() == 4);
  REQUIRE(found.size() == expected.size());
  for (const auto& one : expected) {
    CHECK(std::ranges::any_of(found, [&](const auto& other) { return other.at == one.at; }));
  }
}

TEST_CASE("round shapes touch at their nearest points, and are told apart") {
  Shape ball = box({0, 0, 3}, {}), bar = box({0, 0, 0}, {});
  ball.kind = Shape::Kind::sphere, bar.kind = Shape::Kind::capsule;
  ball.radius = 2, bar.radius = 1, bar.half_length = 4;
  bar.pose.turn.axes = {Vector{0, 1, 0}, Vector{0, 0, 1}, Vector{1, 0, 0}};
  const auto found = points_of(ball, bar);
  REQUIRE(found.size() == 1);
  CHECK(found[0].at == Vector{0, 0, 1});
  CHECK(found[0].radius == 2);
  CHECK(found[0].on_radius == Rational(1));
  CHECK(found[0].only_at_rest);
  ball.pose.at.z = Rational(31, 10);
  CHECK(points_of(ball, bar).empty());
}

TEST_CASE("several joints of one body have massless links between them, and armatures of their own") {
  if (!has_parsers()) return;
  const auto found = import_text(
      mjcf_of("<body name=\"a\" pos=\"0 0 1\"><freejoint/><geom type=\"sphere\" size=\"1\" mass=\"1\"/>"
              "<body name=\"b\" pos=\"0 0 3\"><joint name=\"x\" axis=\"1 0 0\"/><joint name=\"y\" axis=\"0 1 0\" "
              "armature=\"0.5\"/><geom type=\"sphere\" size=\"0.5\" mass=\"1\"/></body></body>"));
  CHECK(found.bodies() == 3);
  CHECK(found.count("hinge") == 2);
  CHECK(found.text.find("armature = \"1/2\"") != std::string::npos);
}

TEST_CASE("keyframes are found by name") {
  if (!has_parsers()) return;
  const std::string text =
      mjcf_of(free_body("a", "0 0 2", "type=\"sphere\" size=\"1\""),
              "<keyframe><key name=\"down\" qpos=\"0 0 1 1 0 0 0\" qvel=\"1 0 0 0 1 0\"/></keyframe>");
  CHECK(import_text(text).tells("keyframes down"));
  CHECK(import_text(text).text.find("state = \"open\"") != std::string::npos);
  const auto down = import_text(text, {}, {"down", false, {}});
  CHECK(down.mechanism.contacts.size() == 1);
  CHECK(down.text.find("velocity = [\"1\", \"0\", \"0\"]\nspin = [\"0\", \"1\", \"0\"]") != std::string::npos);
  CHECK(refusal(text, {}, {"up", false, {}}).find("expected one of: down") != std::string::npos);
}

TEST_CASE("connected bodies have a ball joint, welded ones are one") {
  if (!has_parsers()) return;
  const std::string two =
      free_body("a", "0 0 2", "type=\"sphere\" size=\"0.5\"") + free_body("b", "2 0 2", "type=\"sphere\" size=\"0.5\"");
  const auto connected =
      import_text(mjcf_of(two, "<equality><connect body1=\"a\" body2=\"b\" anchor=\"1 0 0\"/></equality>"));
  CHECK(connected.count("ball") == 1);
  const auto welded = import_text(mjcf_of(two, "<equality><weld body1=\"a\" body2=\"b\"/></equality>"));
  CHECK(welded.bodies() == 1);
  CHECK(welded.text.find("mass = \"2\"") != std::string::npos);
}

TEST_CASE("robots are moved to stand on the ground where this is asked for") {
  if (!has_parsers()) return;
  const std::string text = mjcf_of(free_body("a", "0 0 2", "type=\"box\" size=\"0.5 0.5 0.5\"") +
                                   free_body("b", "3 0 0.2", "type=\"sphere\" size=\"0.5\""));
  CHECK(refusal(text).find("b_shape and floor are inside each other") != std::string::npos);
  imported::SpaceOptions options;
  options.stand = true;
  const auto found = import_text(text, options);
  CHECK(found.mechanism.contacts.size() == 5);
  CHECK(found.tells("a and what it carries: moved down by 1.5"));
  CHECK(found.tells("b and what it carries: moved up by 0.3"));
  options.stand = false;
  options.overlaps = imported::Overlaps::left_out;
  CHECK(import_text(text, options).tells("inside each other: no contact between them"));
}

TEST_CASE("many robots are read") {
  if (!has_parsers()) return;
  std::string all;
  for (int i = 0; i < 40; ++i) {
    all += free_body("b" + std::to_string(i), std::to_string(3 * i) + " 0 1", "type=\"sphere\" size=\"1\"");
  }
  const auto found = import_text(mjcf_of(all));
  CHECK(found.bodies() == 40);
  CHECK(found.mechanism.contacts.size() == 40);
}

TEST_CASE("models in models, balls, universal joints and springs of SDF are read") {
  if (!has_parsers()) return;
  const auto link = [](const std::string& name, const std::string& pose) {
    return "<link name=\"" + name + "\"><pose>" + pose +
           "</pose><inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>0</ixy><ixz>0</ixz>"
           "<iyz>0</iyz></inertia></inertial></link>";
  };
  const auto found = import_text(
      "<sdf version=\"1.9\"><model name=\"m\">" + link("a", "0 0 1 0 0 0") +
      "<model name=\"inner\"><pose>0 0 2 0 0 0</pose>" + link("b", "1 0 0 0 0 0") + "</model>" +
      link("c", "0 0 5 0 0 0") + link("d", "0 0 7 0 0 0") +
      "<joint name=\"j\" type=\"ball\"><parent>a</parent><child>inner::b</child></joint>"
      "<joint name=\"k\" type=\"universal\"><parent>inner::b</parent><child>c</child><axis><xyz>1 0 0</xyz></axis>"
      "<axis2><xyz>0 1 0</xyz></axis2></joint>"
      "<joint name=\"l\" type=\"revolute\"><parent>c</parent><child>d</child><axis><xyz>0 0 1</xyz><dynamics>"
      "<spring_stiffness>3</spring_stiffness><spring_reference>2</spring_reference></dynamics></axis></joint>"
      "</model></sdf>");
  CHECK(found.bodies() == 5);
  CHECK(found.count("ball") == 1);
  CHECK(found.count("hinge") == 3);
  CHECK(found.text.find("name = \"inner_b\"") != std::string::npos);
  CHECK(found.text.find("at = [\"1\", \"0\", \"2\"]") != std::string::npos);
  CHECK(found.text.find("is = [\"0\", \"0\", \"6\"]\nback_on = \"c\"") != std::string::npos);
}

TEST_CASE("a mesh of URDF is its convex hull") {
  if (!has_parsers()) return;
  const auto folder = std::filesystem::temp_directory_path() / "slipproof-space-test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "roof.obj") << "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 1\n"
                                        "f 1 3 2\nf 1 4 3\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
  const std::string text =
      "<robot name=\"r\"><link name=\"a\"><inertial><mass value=\"2\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" "
      "iyy=\"1\" "
      "iyz=\"0\" izz=\"1\"/></inertial><collision><geometry><mesh filename=\"package://any/roof.obj\" scale=\"2 1 1\"/>"
      "</geometry></collision></link></robot>";
  imported::SpaceOptions options;
  options.ground = 0;
  options.mu = 1;
  const auto found = import_text(text, options, {}, (folder / "scene.urdf").string());
  CHECK(found.mechanism.contacts.size() == 4);
  CHECK(found.text.find("point = [\"2\", \"1\", \"0\"]") != std::string::npos);
  std::filesystem::remove_all(folder);
  CHECK(refusal(text, options).find("found the mesh 'package://any/roof.obj', which is not there") !=
        std::string::npos);
  CHECK(import_text(text, options, {"", true, {}}).tells("left out: the mesh"));
}
