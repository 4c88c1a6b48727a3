// What outlines reach, and whether they lie in each other, by their corners alone.
#include <algorithm>

#include "mechanics/checks/drawing/drawing.hpp"

namespace slipproof::mechanism_checks::drawn {

namespace {

/// Whether all corners of `one` are on one side of a plane with this normal, and all of the other on the other side.
bool separates(const Spot& normal, const Outline& one, const Outline& other) {
  const auto along = [&](const Spot& corner) { return dot(corner, normal); };
  const auto range = [&](const Outline& outline) {
    const auto [low, high] = std::ranges::minmax(outline.corners, {}, along);
    return std::pair(along(low), along(high));
  };
  const auto [low, high] = range(one);
  const auto [other_low, other_high] = range(other);
  return high <= other_low || other_high <= low;
}

/// Edges, or more: the differences of all corners.
std::vector<Spot> edges(const Outline& outline) {
  std::vector<Spot> result;
  for (std::size_t i = 0; i < outline.corners.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) result.push_back(outline.corners[i] - outline.corners[k]);
  }
  return result;
}

/// Of hulls with a plane between them one is along a face of one of them, or along an edge of each.
bool hulls_are_apart(const Outline& a, const Outline& b, std::size_t dimension) {
  const std::vector<Spot> of_a = edges(a), of_b = edges(b);
  const auto apart_along = [&](const Spot& x, const Spot& y) {
    const Spot normal = cross(x, y);
    return normal != Spot() && separates(normal, a, b);
  };
  for (std::size_t i = 0; i < dimension; ++i) {  // at once, where they are far apart
    if (separates({i == 0 ? 1 : 0, i == 1 ? 1 : 0, i == 2 ? 1 : 0}, a, b)) return true;
  }
  if (dimension == 2) {
    const Spot out{0, 0, 1};
    const auto apart = [&](const Spot& edge) { return apart_along(edge, out); };
    return std::ranges::any_of(of_a, apart) || std::ranges::any_of(of_b, apart);
  }
  const auto any = [&](const std::vector<Spot>& some, const std::vector<Spot>& others) {
    return std::ranges::any_of(some, [&](const Spot& x) {
      return std::ranges::any_of(others, [&](const Spot& y) { return apart_along(x, y); });
    });
  };
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
