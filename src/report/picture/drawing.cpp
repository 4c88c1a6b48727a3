#include "report/picture/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "report/picture/polyline.hpp"

namespace slipproof {

std::string_view dashes_of(ArrowLine line) {
  return line == ArrowLine::dashed ? "4 3" : line == ArrowLine::dotted ? "1.5 2.5" : "";
}

void add_arrow(const Element& svg, Point from, double dx, double dy, std::string_view css_class, ArrowLine line) {
  const double length = std::hypot(dx, dy);
  if (length < 1) return;
  const double ux = dx / length, uy = dy / length, head = std::min(8.0, length);
  const double tip_x = from[0] + dx, tip_y = from[1] + dy, bx = tip_x - head * ux, by = tip_y - head * uy;
  const double w = head * 0.45;
  const Element group = svg.add("g", css_class);
  const Element shaft = group.add("line").set("x1", from[0]).set("y1", from[1]).set("x2", bx).set("y2", by);
  if (line != ArrowLine::solid) shaft.set("stroke-dasharray", dashes_of(line));
  group.add("path")
      .set("stroke", "none")
      .set("d", fmt::format("M{:.2f},{:.2f}L{:.2f},{:.2f}L{:.2f},{:.2f}Z", tip_x, tip_y, bx - w * uy, by + w * ux,
                            bx + w * uy, by - w * ux));
}

double add_turn(const Element& svg, Point centre, bool counterclockwise, std::string_view css_class) {
  constexpr double radius = 11;
  constexpr int steps = 18;
  const double side = counterclockwise ? -1 : 1;  // y points down
  std::vector<Pixel> arc;
  for (int i = 0; i <= steps; ++i) {  // from above or below to the left
    const double angle = side * (i * 1.5 / steps - 0.5) * std::numbers::pi;
    arc.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
  }
  svg.add("path", css_class).set("style", "fill:none").set("d", path_of(arc));
  add_arrow(svg, {centre[0] - radius, centre[1] + side}, 0, -side * 8, css_class);
  return radius;
}

bool cover(Point from, Point to, Point other_from, Point other_to) {
  constexpr double beside = 3, shared = 2;
  const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
  const auto along = [&](Point p) { return (dx * (p[0] - from[0]) + dy * (p[1] - from[1])) / length; };
  const auto away = [&](Point p) { return std::abs(dx * (p[1] - from[1]) - dy * (p[0] - from[0])) / length; };
  if (away(other_from) > beside || away(other_to) > beside) return false;
  const auto [nearest, farthest] = std::minmax(along(other_from), along(other_to));
  return nearest < length - shared && farthest > shared;
}

}  // namespace slipproof
