// The common parts of pictures of mechanisms: arrows, and values next to them.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/number/rational.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// A place in a picture, in pixels, y down.
using Point = std::array<double, 2>;

enum class ArrowLine : std::uint8_t { solid, dashed };

/// Adds an arrow from a point along (dx, dy); its tip is at the end of this vector. Adds nothing if it would be shorter
/// than a pixel.
void add_arrow(const Element& svg, Point from, double dx, double dy, std::string_view css_class,
               ArrowLine line = ArrowLine::solid);

/// The exact value if it fits next to an arrow; otherwise a decimal.
std::string label_value(const Rational& x);

}  // namespace slipproof
