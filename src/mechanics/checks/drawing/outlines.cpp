// What outlines reach, and whether they lie in each other, by their corners alone.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/rounding/approximate.hpp"
#include "mechanics/checks/drawing/drawing.hpp"

namespace slipproof::mechanism_checks::drawn {

namespace {

/// Whether all corners of `one` are on one side of a plane with this normal, and all of the other on the other side.
bool separates(const Spot& normal, const Outline& one, const Outline& other) {
  const auto range = [&](const Outline& outline) {
    std::vector<Rational> places;
    for (const Spot& corner : outline.corners) places.push_back(dot(corner, normal));
    const auto [low, high] = std::ranges::minmax(places);
    return std::pair(low, high);
  };
  const auto [low, high] = range(one);
  const auto [other_low, other_high] = range(other);
  return high <= other_low || other_high <= low;
}

/// A place in binary64, with bounds on its errors.
using NearSpot = std::array<Approximate, 3>;

NearSpot near(const Spot& spot) {
  return {Approximate(spot.x), Approximate(spot.y), Approximate(spot.z)};
}
std::vector<NearSpot> near(const std::vector<Spot>& spots) {
  std::vector<NearSpot> result;
  for (const Spot& spot : spots) result.push_back(near(spot));
  return result;
}
NearSpot cross(const NearSpot& a, const NearSpot& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The lowest and the highest corner along a normal, about.
std::pair<Approximate, Approximate> ends(const std::vector<NearSpot>& corners, const NearSpot& normal) {
  std::vector<Approximate> places;
  for (const NearSpot& c : corners) places.push_back(c[0] * normal[0] + c[1] * normal[1] + c[2] * normal[2]);
  const auto [low, high] = std::ranges::minmax(places, {}, &Approximate::value);
  return {low, high};
}

/// Whether binary64 is sure that no plane with this normal separates them.
bool surely_meet(const NearSpot& normal, const std::vector<NearSpot>& one, const std::vector<NearSpot>& other) {
  const auto [low, high] = ends(one, normal);
  const auto [other_low, other_high] = ends(other, normal);
  return sure_sign(high - other_low) == 1 && sure_sign(other_high - low) == 1;
}

/// Edges, or more: the differences of all corners.
std::vector<Spot> edges(const Outline& outline) {
  std::vector<Spot> result;
  for (std::size_t i = 0; i < outline.corners.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) result.push_back(outline.corners[i] - outline.corners[k]);
  }
  return result;
}

/// Of hulls with a plane between them one is along a face of one of them, or along an edge of each. Most planes are
/// ruled out by binary64.
bool hulls_are_apart(const Outline& a, const Outline& b, std::size_t dimension) {
  const std::vector<NearSpot> near_a = near(a.corners), near_b = near(b.corners);
  const auto apart_along = [&](const Spot& x, const NearSpot& near_x, const Spot& y, const NearSpot& near_y) {
    if (surely_meet(cross(near_x, near_y), near_a, near_b)) return false;
    const Spot normal = cross(x, y);
    return normal != Spot() && separates(normal, a, b);
  };
  for (std::size_t i = 0; i < dimension; ++i) {  // at once, where they are far apart
    if (separates({i == 0 ? 1 : 0, i == 1 ? 1 : 0, i == 2 ? 1 : 0}, a, b)) return true;
  }
  const std::vector<Spot> of_a = edges(a), of_b = edges(b), out{{0, 0, 1}};
  const auto any = [&](const std::vector<Spot>& some, const std::vector<Spot>& others) {
    const std::vector<NearSpot> near_some = near(some), near_others = near(others);
    for (std::size_t i = 0; i < some.size(); ++i) {
      for (std::size_t k = 0; k < others.size(); ++k) {
        if (apart_along(some[i], near_some[i], others[k], near_others[k])) return true;
      }
    }
    return false;
  };
  if (dimension == 2) return any(of_a, out) || any(of_b, out);
  return any(of_a, of_a) || any(of_b, of_b) || any(of_a, of_b);
}

}  // namespace

bool reaches_beyond(const Outline& outline, const Spot& place, const Spot& direction) {
  return std::ranges::any_of(outline.corners, [&](const Spot& corner) {
    const Rational along = dot(corner - place, direction);
    if (outline.radius.is_zero() || outline.blunt) return along.sign() > 0;
    const Rational reach = outline.radius * outline.radius * dot(direction, direction);
    return along.sign() > 0 || along * along < reach;
  });
}

bool overlap(const Outline& a, const Outline& b, std::size_t dimension) {
  constexpr std::size_t most_corners = 12;
  const auto is_ball = [](const Outline& one) { return one.corners.size() == 1 && one.radius.sign() > 0; };
  if (is_ball(a) && is_ball(b)) {
    const Spot between = a.corners[0] - b.corners[0];
    return dot(between, between) < (a.radius + b.radius) * (a.radius + b.radius);
  }
  if (is_ball(b) && !is_ball(a)) return overlap(b, a, dimension);
  const auto is_hull = [&](const Outline& one) {
    return one.radius.is_zero() && one.corners.size() > dimension && one.corners.size() <= most_corners;
  };
  if (!is_hull(b)) return false;
  // Of a ball in front of a hull only its middle is compared.
  if (is_ball(a)) return dimension == 3 && !hulls_are_apart(a, b, dimension);
  return is_hull(a) && !hulls_are_apart(a, b, dimension);
}

bool face_ends_before(const Outline& outline, const Spot& place, const Spot& normal) {
  std::vector<Spot> face;
  for (const Spot& corner : outline.corners) {
    if (dot(corner - place, normal).is_zero()) face.push_back(corner - place);
  }
  // A line through two corners that leaves all of the face on one side, and the place on the other.
  bool has_area = false, ends = false;
  for (std::size_t i = 0; i < face.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Spot out = cross(face[i] - face[k], normal);
      const Rational border = dot(face[i], out);
      int inside = 0;
      for (const Spot& corner : face) inside |= dot(corner, out) == border ? 0 : dot(corner, out) < border ? 1 : 2;
      has_area = has_area || inside != 0;
      ends = ends || (inside == 1 && border.sign() < 0) || (inside == 2 && border.sign() > 0);
    }
  }
  return has_area && ends;
}

}  // namespace slipproof::mechanism_checks::drawn
