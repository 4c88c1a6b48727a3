// Convex solids in pictures: closed, convex, and painted in the order in which a ray meets them.
#include "report/picture/space/solid.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <random>

using namespace slipproof;

namespace {

struct Box {
  Vec3 low, high;
};

/// How far from the viewer's side, along the ray to `towards`, the last point inside is (slabs); nothing if it misses.
std::optional<double> nearest_inside(const Box& box, const Vec3& at, const Vec3& towards) {
  double enters = std::numeric_limits<double>::lowest(), leaves = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < 3; ++i) {
    double one = (box.low[i] - at[i]) / towards[i], other = (box.high[i] - at[i]) / towards[i];
    if (one > other) std::swap(one, other);
    enters = std::max(enters, one), leaves = std::min(leaves, other);
  }
  return enters < leaves ? std::optional(leaves) : std::nullopt;
}

}  // namespace

TEST_CASE("of two solids the one that a ray from the viewer meets first is painted last") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vec3{number(random), number(random), number(random)}; };
  int compared = 0;
  for (int round = 0; round < 2000; ++round) {
    std::array<Box, 2> boxes;
    std::vector<Solid> solids;
    for (Box& box : boxes) {
      const Vec3 centre = vector(), half{0.05 + std::abs(number(random)), 0.05 + std::abs(number(random)),
                                         0.05 + std::abs(number(random))};
      box = {centre - half, centre + half};
      solids.push_back(box_solid(centre, 2 * half));
    }
    bool apart = false;
    for (std::size_t i = 0; i < 3; ++i)
      apart = apart || boxes[0].high[i] < boxes[1].low[i] || boxes[1].high[i] < boxes[0].low[i];
    if (!apart) continue;
    const Vec3 towards = direction_of(vector());
    const auto order = painting_order(solids, towards);
    REQUIRE(order.size() == 2);
    for (int ray = 0; ray < 20; ++ray) {
      const Vec3 at = vector();
      const auto first = nearest_inside(boxes[0], at, towards), second = nearest_inside(boxes[1], at, towards);
      if (!first || !second) continue;
      CHECK(order.back() == (*first > *second ? 0U : 1U));
      ++compared;
    }
  }
  CHECK(compared > 200);
}

TEST_CASE("hulls are closed and convex, with the faces that the shape has") {
  std::mt19937_64 random(2);
  std::normal_distribution<double> number;
  for (int round = 0; round < 50; ++round) {
    std::vector<Vec3> points;
    for (int i = 0; i < 30; ++i) points.push_back({number(random), number(random), number(random)});
    const Solid solid = hull_solid(points);
    for (const Solid::Face& face : solid.faces) {
      for (const Vec3& p : points) CHECK(dot(face.normal, p - points[face.corners[0]]) < 1e-9);
    }
    std::vector<bool> used(points.size());
    for (const Solid::Edge& edge : solid.edges) {
      CHECK(edge.faces.size() == 2);
      used[edge.from] = used[edge.to] = true;
    }
    const auto corners = static_cast<std::size_t>(std::ranges::count(used, true));
    CHECK(corners + solid.faces.size() == solid.edges.size() + 2);  // Euler
  }
  CHECK(box_solid({1, 2, 3}, {1, 2, 3}).faces.size() == 6);
  CHECK(hull_solid({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}}).faces.size() == 1);  // flat
}

TEST_CASE("round solids are as large as they should be") {
  const auto reach = [](const Solid& solid, const Vec3& along) {
    double most = 0;
    for (const Vec3& p : solid.corners) most = std::max(most, dot(p, along));
    return most;
  };
  for (const Vec3& along : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    CHECK(reach(sphere_solid({0, 0, 0}, 2), along) == doctest::Approx(2).epsilon(0.02));
  }
  const Solid capsule = cylinder_solid({0, 0, 0}, {1, 0, 0}, 1, 4, true),
              rod = cylinder_solid({0, 0, 0}, {0, 3, 0}, 1, 4, false);
  CHECK(reach(capsule, {1, 0, 0}) == doctest::Approx(3).epsilon(0.02));
  CHECK(reach(capsule, {0, 0, 1}) == doctest::Approx(1).epsilon(0.02));
  CHECK(reach(rod, {0, 1, 0}) == doctest::Approx(2));
  for (const Solid& solid : {capsule, rod}) {
    for (const Solid::Face& face : solid.faces) CHECK(dot(face.normal, solid.corners[face.corners[0]]) > 0);
  }
}
