// Where shapes touch in space.
#pragma once

#include <optional>
#include <vector>

#include "contact/exchange/touch.hpp"

namespace slipproof::imported {

/// A point or a sphere of one body on a plane or a sphere of another.
struct SpatialContact {
  std::size_t of = 0, on = 0;  ///< bodies
  const Shape *shape_of = nullptr, *shape_on = nullptr;
  Vector at, normal;      ///< out of the second body, of length 1
  Rational distance = 0;  ///< distance by which the shapes were moved to touch
  Rational radius = 0;    ///< of a sphere of the first body; its centre is so far from `at` along the normal
  std::optional<Rational> on_radius;  ///< of a sphere of the second body; nothing: a plane
  bool only_at_rest = false;          ///< the surfaces are curved otherwise, or turn apart: exact for bodies at rest
};

/// Which shapes may overlap, or touch in a way that is not supported: those do not touch, with a note for each pair.
enum class Overlaps : std::uint8_t { refused, within_one_robot, left_out };

/// All contacts of a scene. Reports other overlapping shapes; adds notes on what was chosen.
std::vector<SpatialContact> spatial_contacts(const Scene& scene, const Rational& touch, Mistakes& mistakes,
                                             std::vector<std::string>& import_notes,
                                             Overlaps overlaps = Overlaps::refused);

/// Two directions of length 1 across a normal and each other.
std::array<Vector, 2> tangents(const Vector& normal);

}  // namespace slipproof::imported
