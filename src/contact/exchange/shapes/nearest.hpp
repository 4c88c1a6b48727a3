// How far two convex shapes are apart, in binary64: what decides where to look, not what is written.
#pragma once

#include "contact/exchange/shapes/polytope.hpp"

namespace slipproof::imported {

/// A convex body by its farthest point in a direction; spheres and capsules without their radius.
struct Core {
  std::vector<Near> points;
  Near axis{};  ///< of a cylinder, with
  double radius = 0, half_length = 0;

  Near farthest(const Near& direction) const;
};
/// Not for planes. `faces` are those of the shape.
Core core_of(const Shape& shape, const Polytope& faces);

struct Nearest {
  double distance = 0;  ///< 0: they meet
  Near on_a{}, on_b{};  ///< the two points
};

/// The nearest points of two bodies, by Gilbert, Johnson and Keerthi: the point nearest to 0 of the set of differences,
/// in a simplex of at most four of its extreme points, which each step moves nearer. Within about 1e-9 of the sizes.
Nearest nearest_points(const Core& a, const Core& b);

}  // namespace slipproof::imported
