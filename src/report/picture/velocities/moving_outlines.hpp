// Outlines that move, as elements with a CSS animation.
#pragma once

#include <functional>
#include <vector>

#include "report/markup/element.hpp"
#include "report/picture/mechanism_geometry.hpp"

namespace slipproof {

/// Adds outlines, of the first frame, that go through all frames in `seconds` of real time, rest at the last one, and
/// begin again. They stand at the last one where nothing may move (prefers-reduced-motion), or no animation is known.
/// `pixel` places a point of the scene, `scale` is its pixels for a length of 1.
void add_moving_outlines(const Element& svg, const std::vector<std::vector<MechanismGeometry::Outline>>& frames,
                         double seconds, double scale, const std::function<Point(Point)>& pixel);

}  // namespace slipproof
