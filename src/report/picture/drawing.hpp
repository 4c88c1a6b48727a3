// What pictures of mechanisms draw alike: arrows, and values beside them.
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

/// An arrow from a point along (dx, dy), which is also where its tip is; none that is shorter than a pixel.
void add_arrow(const Element& svg, Point from, double dx, double dy, std::string_view css_class,
               ArrowLine line = ArrowLine::solid);

/// An exact value that fits beside an arrow, or a decimal.
std::string label_value(const Rational& x);

}  // namespace slipproof
