#include "report/picture/space/flat.hpp"

#include <algorithm>
#include <cmath>

namespace slipproof {

namespace {

/// Positive where c is on the left of the line from a to b.
double left_of(Point a, Point b, Point c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace

std::vector<Point> hull_of(std::vector<Point> points) {
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  const auto half = [&](const auto& all) {
    const std::size_t first = hull.size();
    for (const Point& p : all) {
      while (hull.size() >= first + 2 && left_of(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
  };
  half(points);
  std::ranges::reverse(points);
  half(points);
  return hull;
}

bool is_inside(Point point, const std::vector<Point>& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point from = polygon[i], to = polygon[(i + 1) % polygon.size()];
    if (left_of(from, to, point) < -std::hypot(to[0] - from[0], to[1] - from[1])) return false;
  }
  return true;
}

std::vector<Point> clipped(std::vector<Point> polygon, const std::vector<Point>& inside) {
  for (std::size_t i = 0; i < inside.size() && !polygon.empty(); ++i) {
    const Point from = inside[i], to = inside[(i + 1) % inside.size()];
    std::vector<Point> kept;
    for (std::size_t j = 0; j < polygon.size(); ++j) {
      const Point a = polygon[j], b = polygon[(j + 1) % polygon.size()];
      const double at_a = left_of(from, to, a), at_b = left_of(from, to, b);
      if (at_a >= 0) kept.push_back(a);
      if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) {
        const double share = at_a / (at_a - at_b);
        kept.push_back({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])});
      }
    }
    polygon = std::move(kept);
  }
  return polygon;
}

}  // namespace slipproof
