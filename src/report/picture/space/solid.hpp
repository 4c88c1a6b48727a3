// Convex solids of flat faces, as pictures draw them: built from shapes, seen from a side, and in the order in which
// they hide each other.
#pragma once

#include <cstddef>
#include <vector>

#include "report/picture/space/vectors.hpp"

namespace slipproof {

struct Solid {
  struct Face {
    std::vector<std::size_t> corners;  ///< counterclockwise seen from outside
    Vec3 normal{};                     ///< out of the solid, of length 1
  };
  /// An edge has one face, of a flat piece, or two.
  struct Edge {
    std::size_t from = 0, to = 0;
    std::vector<std::size_t> faces;
    bool smooth = false;  ///< its faces stand for a round surface
  };
  std::vector<Vec3> corners;
  std::vector<Face> faces;
  std::vector<Edge> edges;

  Vec3 middle() const;
};

/// The largest distance of a point from the first.
double extent(const std::vector<Vec3>& points);

// In the axes of their body.
Solid box_solid(const Vec3& centre, const Vec3& size);
Solid sphere_solid(const Vec3& centre, double radius);
/// `length` is that of the straight part, along `axis`; round ends make a capsule.
Solid cylinder_solid(const Vec3& centre, const Vec3& axis, double radius, double length, bool round_ends);
/// The convex hull; flat or without faces where the points are in a plane or on a line.
Solid hull_solid(const std::vector<Vec3>& points);
/// A flat convex polygon, seen from both sides.
Solid flat_solid(const std::vector<Vec3>& corners);

/// The solids by number, so that each is after those that it hides, seen from a direction. Exact for solids that some
/// plane of a face keeps apart; otherwise the nearer middle is later.
std::vector<std::size_t> painting_order(const std::vector<Solid>& solids, const Vec3& towards);

}  // namespace slipproof
