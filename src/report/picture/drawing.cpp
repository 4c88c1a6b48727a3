#include "report/picture/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number/format.hpp"

namespace slipproof {

void add_arrow(const Element& svg, Point from, double dx, double dy, std::string_view css_class, ArrowLine line) {
  const double length = std::hypot(dx, dy);
  if (length < 1) return;
  const double ux = dx / length, uy = dy / length, head = std::min(8.0, length);
  const double tip_x = from[0] + dx, tip_y = from[1] + dy, bx = tip_x - head * ux, by = tip_y - head * uy;
  const double w = head * 0.45;
  const Element group = svg.add("g", css_class);
  const Element shaft = group.add("line").set("x1", from[0]).set("y1", from[1]).set("x2", bx).set("y2", by);
  if (line == ArrowLine::dashed) shaft.set("stroke-dasharray", "4 3");
  group.add("path")
      .set("stroke", "none")
      .set("d", fmt::format("M{:.2f},{:.2f}L{:.2f},{:.2f}L{:.2f},{:.2f}Z", tip_x, tip_y, bx - w * uy, by + w * ux,
                            bx + w * uy, by - w * ux));
}

std::string label_value(const Rational& x) {
  std::string text = exact_text(x);
  if (text.size() > 9) text = "≈ " + decimal_text(x, 4);
  if (const std::size_t minus = text.find('-'); minus != text.npos) text.replace(minus, 1, "−");
  return text;
}

}  // namespace slipproof
