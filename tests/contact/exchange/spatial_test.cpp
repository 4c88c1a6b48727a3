// Scenes in space: contacts where they are by hand, and equations against those of the plane.
#include "contact/exchange/spatial.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "contact/exchange/export_scene.hpp"
#include "contact/exchange/shapes/spatial_contacts.hpp"
#include "contact/exchange/written.hpp"
#include "contact/formats/json_problem.hpp"
#include "mechanics/scene/scene.hpp"

using namespace slipproof;
using imported::Shape;
using imported::Vector;

namespace {

imported::Scene on_the_ground() {
  imported::Scene scene;
  scene.format = "test";
  scene.gravity = Vector{0, 0, -10};
  scene.rule = imported::FrictionRule::least;
  return scene;
}

imported::Body body(const Shape& shape) {
  imported::Body body;
  body.name = shape.name;
  body.mass = 2;
  body.inertia = {1, 1, 1, 0, 0, 0};
  body.at = shape.pose.at;
  body.shapes = {shape};
  return body;
}

Shape box(const std::string& name, const Vector& at, const Vector& half) {
  Shape shape;
  shape.name = name;
  shape.pose.at = at;
  shape.half = half;
  shape.mu = Rational(1, 2);
  return shape;
}

std::vector<Vector> places(const imported::Scene& scene) {
  Mistakes mistakes("test");
  std::vector<std::string> import_notes;
  std::vector<Vector> result;
  for (const auto& contact : spatial_contacts(scene, Rational(1, 10000), mistakes, import_notes))
    result.push_back(contact.at);
  CHECK(mistakes.empty());
  return result;
}

bool has(const std::vector<Vector>& all, const Vector& one) {
  return std::ranges::find(all, one) != all.end();
}

}  // namespace

TEST_CASE("a box on the ground touches with four corners") {
  imported::Scene scene = on_the_ground();
  scene.bodies.push_back(body(box("crate", {1, 2, 3}, {1, 2, 3})));
  imported::TouchOptions options;
  options.ground = 0;
  options.mu = Rational(1, 2);
  const GlobalProblem found = to_spatial(scene, options).problem;
  REQUIRE(found.contacts.size() == 4);
  CHECK(found.mu == std::vector<Rational>(4, Rational(1, 2)));
  CHECK(found.f == std::vector<Rational>{0, 0, -20, 0, 0, 0});
  for (std::size_t k = 0; k < 4; ++k) {  // the normal pushes up, and turns by the arm across it
    CHECK(found.H[2][3 * k] == 1);
    CHECK(abs(found.H[3][3 * k]) == 2);
    CHECK(abs(found.H[4][3 * k]) == 1);
    CHECK(found.H[5][3 * k] == 0);
    CHECK(abs(found.H[4][3 * k + 1]) == 3);  // friction along x turns about y by the height
  }
}

TEST_CASE("crossed beams touch in the corners of a square where no corner of a beam is") {
  imported::Scene scene = on_the_ground();
  scene.bodies.push_back(body(box("lower", {0, 0, 0}, {5, 1, 1})));
  scene.bodies.push_back(body(box("upper", {0, 0, 2}, {1, 5, 1})));
  const auto found = places(scene);
  CHECK(found.size() == 4);
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) CHECK(has(found, {x, y, 1}));
  }
}

TEST_CASE("a box turned by 3-4-5 on a box touches in eight points, a corner of which is on no edge") {
  imported::Scene scene = on_the_ground();
  scene.bodies.push_back(body(box("lower", {0, 0, 0}, {1, 1, 1})));
  Shape turned = box("upper", {0, 0, 2}, {1, 1, 1});
  turned.pose.turn.axes = {Vector{Rational(3, 5), Rational(4, 5), 0}, Vector{Rational(-4, 5), Rational(3, 5), 0},
                           Vector{0, 0, 1}};
  scene.bodies.push_back(body(turned));
  const auto found = places(scene);
  CHECK(found.size() == 8);
  for (const Vector& p : found) {
    CHECK(p.z == 1);
    const bool on_edge = abs(p.x) == 1 || abs(p.y) == 1;
    CHECK(on_edge);
  }
}

TEST_CASE("what is farther apart than the touch does not touch, what is inside is refused") {
  imported::Scene scene = on_the_ground();
  scene.bodies.push_back(body(box("a", {0, 0, 0}, {1, 1, 1})));
  scene.bodies.push_back(body(box("b", {0, 0, Rational(201, 100)}, {1, 1, 1})));
  CHECK(places(scene).empty());
  scene.bodies[2].shapes[0].pose.at.z = 1;
  Mistakes mistakes("test");
  std::vector<std::string> import_notes;
  CHECK(spatial_contacts(scene, Rational(1, 10000), mistakes, import_notes).empty());
  CHECK_FALSE(mistakes.empty());
}

TEST_CASE("a cylinder that stands touches with four points of its rim, one that lies with two") {
  imported::Scene scene = on_the_ground();
  Shape cylinder = box("drum", {0, 0, 1}, {});
  cylinder.kind = Shape::Kind::cylinder;
  cylinder.radius = 3;
  cylinder.half_length = 1;
  scene.bodies.push_back(body(cylinder));
  Shape floor = box("floor", {0, 0, 0}, {});
  floor.kind = Shape::Kind::plane;
  scene.bodies[0].shapes.push_back(floor);
  CHECK(places(scene).size() == 4);
  scene.bodies[1].shapes[0].pose.turn.axes = {Vector{0, 1, 0}, Vector{0, 0, 1}, Vector{1, 0, 0}};
  scene.bodies[1].shapes[0].pose.at.z = 3;
  const auto lying = places(scene);
  CHECK(lying.size() == 2);
  CHECK(has(lying, {1, 0, 0}));
  CHECK(has(lying, {-1, 0, 0}));
}

TEST_CASE("tangents are across the normal and each other") {
  for (const Vector& n : {Vector{0, 0, 1}, Vector{0, 0, -1}, Vector{Rational(2, 3), Rational(-1, 3), Rational(2, 3)},
                          Vector{Rational(3, 5), 0, Rational(-4, 5)}}) {
    const auto [a, b] = imported::tangents(n);
    CHECK(dot(a, n).is_zero());
    CHECK(dot(b, n).is_zero());
    CHECK(dot(a, b).is_zero());
    CHECK(dot(a, a) == 1);
    CHECK(dot(b, b) == 1);
  }
}

TEST_CASE("a quarter turn in decimals is one, and another is near what was written") {
  const auto quarter = imported::rational_turn({0.70710678118654757, 0.70710678118654757, 0, 0});
  CHECK(quarter.turn(Vector{0, 1, 0}) == Vector{0, 0, 1});
  const auto rough = imported::rational_turn({0.7073883, 0, 0.7068251, 0});  // 1.57 in place of a right angle
  CHECK(rough.turn(Vector{0, 1, 0}) == Vector{0, 1, 0});
  CHECK(rough.turn(Vector{1, 0, 0}).x != 0);
  const auto third = imported::rational_turn({0.96592582628906831, 0, 0.25881904510252074, 0});  // 30 degrees
  const Vector x = third.turn(Vector{1, 0, 0});
  CHECK(dot(x, x) == 1);
  CHECK(abs(x.x * x.x - Rational(3, 4)) < Rational(1, 1'000'000'000));
}

TEST_CASE("the problem of a scene is read back, and is that of its mechanism") {
  const std::string folder = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/asked/scenes/";
  MechanismScene scene = read_scene(folder + "block-pushed.toml");
  scene.load = Rational(1, 4);
  const GlobalProblem problem = global_problem(scene);
  CHECK(problem.M == RationalMatrix{{1, 0, 0}, {0, 1, 0}, {0, 0, Rational(1552, 3)}});
  CHECK(problem.f == std::vector<Rational>{Rational(1, 4), -1, Rational(-30, 4)});
  CHECK(problem.H == RationalMatrix{{0, 1, 0, 1}, {1, 0, 1, 0}, {-16, 36, 16, 36}});
  const ReadProblem read = read_json_problem(to_json(problem), "problem.json");
  CHECK(read.problem.contacts() == 2);
  CHECK(read.problem.mu == std::vector<double>{0.2, 0.2});
  CHECK(read.problem.remarks.size() == 1);
}

TEST_CASE("what no contact problem says is refused by name") {
  const std::string folder = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/";
  CHECK_THROWS_WITH_AS(global_problem(read_scene(folder + "scenes/bicycle-brakes.toml")),
                       doctest::Contains("friction element with a limit of its own"), InputError);
  CHECK_THROWS_WITH_AS(global_problem(read_scene(folder + "asked/scenes/block-pushed.toml")),
                       doctest::Contains("found no value of the load F"), InputError);
}
