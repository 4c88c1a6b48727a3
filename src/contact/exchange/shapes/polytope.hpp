// Shapes with flat faces: boxes, convex hulls, and planes, which have one face without an end.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/imported/scene.hpp"

namespace slipproof::imported {

/// Vectors of binary64, for what only decides where to look.
using Near = std::array<double, 3>;
Near near(const Vector& v);
inline double dot(const Near& a, const Near& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Near minus(const Near& a, const Near& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Near cross(const Near& a, const Near& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A face: a convex polygon, counterclockwise seen from outside, a disc, or a whole plane.
struct Face {
  Vector through, normal;  ///< the normal of length 1, out of the shape
  std::vector<Vector> corners;
  bool unlimited = false;
  std::optional<Rational> disc;  ///< the radius about `through`

  Rational distance(const Vector& p) const { return imported::dot(p - through, normal); }
  /// True if a point lies above the face, or beside it by no more than about `touch`.
  bool holds(const Vector& p, const Rational& touch) const;
  /// The part of a polygon, a segment or a point that lies above the face.
  std::vector<Vector> clip(std::vector<Vector> polygon) const;
};

struct Polytope {
  /// A face in binary64, with its outer normal of length 1, and what it is made of.
  struct Side {
    Near normal{};
    double offset = 0;  ///< of its points, along the normal
    std::optional<Face> face;
    std::vector<std::size_t> corners;  ///< without a face: those of a hull, the first on the face
  };
  std::vector<Vector> corners;
  std::vector<Side> sides;
  std::vector<std::array<Vector, 2>> edges;

  /// A face in rationals, which takes time for that of a hull.
  Face face(const Side& side) const;
};

/// The corners of a box or a hull in the scene; none for other shapes.
std::vector<Vector> corners_of(const Shape& shape);

/// The faces, edges and corners of a shape in the scene: of a cylinder its two ends, of other round shapes none. Faces
/// of a hull whose corners lie within a millionth of its size of one plane are one. Cubic in the number of corners of a
/// face.
Polytope polytope_of(const Shape& shape);

/// The corners of the convex polygon of points near a plane, counterclockwise about its normal.
std::vector<Vector> corners_of_polygon(const std::vector<Vector>& points, const Vector& normal);

}  // namespace slipproof::imported
