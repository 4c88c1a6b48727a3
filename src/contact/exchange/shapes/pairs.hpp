// Where two shapes touch.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/exchange/shapes/nearest.hpp"

namespace slipproof::imported {

/// A shape with its faces, if it has any, and with both in binary64: those decide which faces are looked at.
struct Solid {
  const Shape* shape = nullptr;
  Polytope faces;
  Core core;
};
Solid solid_of(const Shape& shape);

struct TouchPoint {
  bool swapped = false;               ///< the normal points out of the first shape instead of the second
  Vector at, normal;                  ///< the normal of length 1
  Rational distance = 0;              ///< of the shapes there, below 0 inside each other; both are moved to meet
  Rational radius = 0;                ///< of the sphere of the shape that the normal points to; 0: a corner
  std::optional<Rational> on_radius;  ///< of a sphere of the shape that it points out of
  bool only_at_rest = false;
};

/// The points at which two shapes touch: corners, ends and rims on faces, the corners of the part that two faces share,
/// edges that cross, round shapes. Empty, with `why` empty, if they are apart by more than `touch`; else `why` says
/// that they overlap, or touch in a way that is not read.
std::vector<TouchPoint> touching(const Solid& a, const Solid& b, const Rational& touch, std::string& why);

/// The least of p . normal over the points p of a shape; nothing for a plane.
std::optional<Rational> least_along(const Shape& shape, const Vector& normal);

}  // namespace slipproof::imported
