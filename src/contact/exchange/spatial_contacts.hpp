// Where shapes touch in space.
#pragma once

#include <vector>

#include "contact/exchange/touch.hpp"

namespace slipproof::imported {

struct SpatialContact {
  std::size_t of = 0, on = 0;  ///< bodies
  const Shape *shape_of = nullptr, *shape_on = nullptr;
  Vector at, normal;      ///< out of the second body, of length 1
  Rational distance = 0;  ///< distance by which the shapes were moved to touch
};

/// All contacts of a scene. Reports overlapping shapes, and kinds of touching that are not supported; adds notes on
/// gaps that were taken for a touch.
std::vector<SpatialContact> spatial_contacts(const Scene& scene, const Rational& touch, Mistakes& mistakes,
                                             std::vector<std::string>& import_notes);

/// Two directions of length 1 across a normal and each other.
std::array<Vector, 2> tangents(const Vector& normal);

}  // namespace slipproof::imported
