// Convex polygons in a plane.
#pragma once

#include <vector>

#include "report/picture/drawing.hpp"

namespace slipproof {

/// The convex hull, counterclockwise with y up (Andrew's monotone chain).
std::vector<Point> hull_of(std::vector<Point> points);

/// Whether a point is inside a convex polygon, or at most a unit outside. Corners are counterclockwise.
bool is_inside(Point point, const std::vector<Point>& polygon);

/// The part of a convex polygon that is inside another, whose corners are counterclockwise (Sutherland and Hodgman).
std::vector<Point> clipped(std::vector<Point> polygon, const std::vector<Point>& inside);

}  // namespace slipproof
