#include "contact/rest/map_polygons.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

/// Twice the area of a triangle, positive counterclockwise.
Rational turn(const MapPoint& a, const MapPoint& b, const MapPoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

MapPoint place(const RestMap::Corner& corner) {
  return {corner.x, corner.y};
}

/// What is left of a polygon where n . p <= most.
std::vector<MapPoint> clipped(const std::vector<MapPoint>& polygon, const MapPoint& n, const Rational& most) {
  std::vector<MapPoint> result;
  const auto add = [&](const MapPoint& p) {
    if (std::ranges::find(result, p) == result.end()) result.push_back(p);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const MapPoint &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const Rational beyond = dot(n, here) - most, beyond_next = dot(n, next) - most;
    if (beyond.sign() <= 0) add(here);
    if (beyond.sign() * beyond_next.sign() >= 0) continue;
    const Rational part = beyond / (beyond - beyond_next);
    add({here[0] + part * (next[0] - here[0]), here[1] + part * (next[1] - here[1])});
  }
  return result;
}

double angle_of_border(const RestMap::Border& border) {
  return std::atan2(nearest_binary64(border.y), nearest_binary64(border.x));
}

/// The same half plane.
bool same_line(const RestMap::Border& a, const RestMap::Border& b) {
  return a.x * b.y == a.y * b.x && a.x * b.most == a.most * b.x && a.y * b.most == a.most * b.y &&
         (a.x * b.x + a.y * b.y).sign() > 0;
}

}  // namespace

Rational dot(const MapPoint& a, const MapPoint& b) {
  return a[0] * b[0] + a[1] * b[1];
}

std::optional<MapPoint> meeting_point(const MapPoint& first, const Rational& most, const MapPoint& second,
                                      const Rational& other_most) {
  const Rational area = first[0] * second[1] - first[1] * second[0];
  if (area.is_zero()) return std::nullopt;
  return MapPoint{(most * second[1] - first[1] * other_most) / area, (first[0] * other_most - most * second[0]) / area};
}

double distance_from(const PlainPoint& p, const PlainPoint& a, const PlainPoint& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
  const double along = square > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - along * dx, p[1] - a[1] - along * dy);
}

void keep_hull(RestMap& map) {
  std::vector<RestMap::Corner>& all = map.inside;
  std::ranges::sort(all, {}, place);
  const auto same = [](const auto& one, const auto& other) { return place(one) == place(other); };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  if (all.size() < 3) return;
  std::vector<RestMap::Corner> hull;
  const auto chain = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto corner = begin; corner != end; ++corner) {
      while (hull.size() > first + 1 &&
             turn(place(hull[hull.size() - 2]), place(hull.back()), place(*corner)).sign() <= 0) {
        hull.pop_back();
      }
      hull.push_back(*corner);
    }
    hull.pop_back();  // the first one of the other chain
  };
  chain(all.begin(), all.end());
  chain(all.rbegin(), all.rend());
  all = std::move(hull);
}

void clip_around(RestMap& map, const std::array<Rational, 4>& ends) {
  const auto& [right, up, left, down] = ends;
  std::vector<MapPoint>& around = map.around;
  around = clipped({{left, down}, {right, down}, {right, up}, {left, up}}, {1, 0}, right);
  for (const RestMap::Border& border : map.borders) around = clipped(around, {border.x, border.y}, border.most);
  std::vector<RestMap::Border> kept;
  std::ranges::stable_sort(map.borders, {}, angle_of_border);
  for (RestMap::Border& border : map.borders) {
    const auto touching = std::ranges::count_if(around, [&](const MapPoint& p) {
      return dot({border.x, border.y}, p) == border.most;
    });
    const bool known =
        std::ranges::any_of(kept, [&](const RestMap::Border& other) { return same_line(border, other); });
    if ((touching > 1 || (around.size() < 3 && touching > 0)) && !known) kept.push_back(std::move(border));
  }
  map.borders = std::move(kept);
}

}  // namespace slipproof
