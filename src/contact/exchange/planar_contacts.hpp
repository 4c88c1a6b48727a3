// Where outlines touch.
#pragma once

#include <string>
#include <vector>

#include "contact/exchange/touch.hpp"
#include "contact/exchange/view.hpp"

namespace slipproof::imported {

/// A point or a disc of one body on a line or a disc of another, as they are in the picture.
struct PlanarContact {
  std::size_t of = 0, on = 0;  ///< bodies
  const Shape *point_of = nullptr, *line_of = nullptr;
  Point centre;                 ///< the point, or the centre of the disc
  Rational radius = 0;          ///< 0: a point
  std::optional<Point> normal;  ///< normal of the line, out of its body
  Point through;                ///< a point of the line, or the centre of the other disc
  Rational on_radius = 0;       ///< radius of the other disc
  Rational distance = 0;        ///< distance by which the line or disc was moved to touch
};

/// All contacts of a scene. Reports overlapping shapes, and kinds of touching that are not supported.
std::vector<PlanarContact> planar_contacts(const Scene& scene, const View& view, const Rational& touch,
                                           Mistakes& mistakes);

}  // namespace slipproof::imported
