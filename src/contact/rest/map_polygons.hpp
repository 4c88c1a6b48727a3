// The polygons of a map of two loads, exactly.
#pragma once

#include <array>
#include <optional>

#include "contact/rest/rest_answer.hpp"

namespace slipproof {

using MapPoint = std::array<Rational, 2>;
using PlainPoint = std::array<double, 2>;

Rational dot(const MapPoint& a, const MapPoint& b);
/// Where two lines n . p = most meet; nothing if they are parallel.
std::optional<MapPoint> meeting_point(const MapPoint& first, const Rational& most, const MapPoint& second,
                                      const Rational& other_most);
/// The distance of a point from the line between two.
double distance_from(const PlainPoint& p, const PlainPoint& a, const PlainPoint& b);

/// Leaves the corners of the hull in `inside`, counterclockwise.
void keep_hull(RestMap& map);
/// Finds `around`, what the borders leave of the box with its ends right, up, left, down, and leaves the borders along
/// which it has an edge, or all where it has no area.
void clip_around(RestMap& map, const std::array<Rational, 4>& ends);

}  // namespace slipproof
