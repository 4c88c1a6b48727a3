// Lengths and turns that a file names, in the picture of a mechanism.
#pragma once

#include <string>
#include <vector>

#include "report/markup/element.hpp"
#include "report/picture/drawing.hpp"
#include "report/picture/labels/picture_labels.hpp"

namespace slipproof {

/// A line with a bar at both ends, and its name. `places` are in pixels: the ends of the line, and perhaps the two
/// places between which it measures, to which dotted lines lead.
void add_measure(const Element& svg, const std::vector<Point>& places, const std::string& name, PictureLabels& labels);

/// Part of a circle above its centre with an arrow at its end, and its name; clockwise if the radius, in pixels, is
/// negative.
void add_named_turn(const Element& svg, Point centre, double radius, const std::string& name, PictureLabels& labels);

}  // namespace slipproof
