// The common parts of pictures of mechanisms: arrows.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "report/markup/element.hpp"

namespace slipproof {

/// A place in a picture, in pixels, y down.
using Point = std::array<double, 2>;

enum class ArrowLine : std::uint8_t { solid, dashed, dotted };

/// Its stroke-dasharray; empty for a solid line.
std::string_view dashes_of(ArrowLine line);

/// Adds an arrow from a point along (dx, dy); its tip is at the end of this vector. Adds nothing if it would be shorter
/// than a pixel.
void add_arrow(const Element& svg, Point from, double dx, double dy, std::string_view css_class,
               ArrowLine line = ArrowLine::solid);

/// Adds three quarters of a circle around a point, with an arrow at its end; returns its radius.
double add_turn(const Element& svg, Point centre, bool counterclockwise, std::string_view css_class);

/// Whether two lines are on top of each other for more than some pixels.
bool cover(Point from, Point to, Point other_from, Point other_to);

}  // namespace slipproof
