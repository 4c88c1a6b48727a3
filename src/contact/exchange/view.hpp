// A scene seen from the side: bodies that stay in one plane, and their outlines in it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/imported/scene.hpp"

namespace slipproof::imported {

/// A point or direction in the picture: to the right, and up.
struct Point {
  Rational x = 0, y = 0;
  bool operator==(const Point&) const = default;
};
inline Point operator+(const Point& a, const Point& b) {
  return {a.x + b.x, a.y + b.y};
}
inline Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Point operator*(const Rational& s, const Point& a) {
  return {s * a.x, s * a.y};
}
inline Rational dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}
inline Rational cross(const Point& a, const Point& b) {
  return a.x * b.y - a.y * b.x;
}

struct View {
  std::string_view name;  ///< `xz`: x to the right, z up
  std::size_t right, up;
  Vector toward;  ///< the viewer, about which angles count counterclockwise

  Point operator()(const Vector& v) const { return {v[right], v[up]}; }
};
const std::vector<View>& views();

/// The outline of a shape in a view.
struct Outline {
  std::vector<Point> corners;  ///< counterclockwise; of a box, a cylinder that lies, and the flanks of a capsule
  bool has_corners = true;     ///< false: the corners are no points that touch, as those of flanks
  std::vector<Point> centres;  ///< centres of discs
  Rational radius = 0;
  std::optional<Point> normal;  ///< normal of a half plane, with
  Point through;
};

/// Nothing if the shape is seen at an oblique angle; then sets `why`.
std::optional<Outline> outline_of(const Shape& shape, const View& view, std::string& why);

/// Why a scene does not stay in a plane; empty: it does.
std::vector<std::string> leaves(const Scene& scene, const View& view);

}  // namespace slipproof::imported
