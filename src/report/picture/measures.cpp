#include "report/picture/measures.hpp"

#include <cmath>
#include <numbers>

#include "report/picture/polyline.hpp"

namespace slipproof {

namespace {

constexpr double bar = 4;

Point midpoint(Point from, Point to) {
  return {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2};
}

void add_line(const Element& svg, Point from, Point to, std::string_view css) {
  svg.add("line", css).set("x1", from[0]).set("y1", from[1]).set("x2", to[0]).set("y2", to[1]);
}

}  // namespace

void add_measure(const Element& svg, const std::vector<Point>& places, const std::string& name, PictureLabels& labels) {
  const Point from = places[0], to = places[1];
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  if (length < 1) return;
  for (std::size_t i = 2; i < places.size(); ++i) {
    add_line(svg, places[i], places[i - 2], "curve");
    labels.avoid(places[i], places[i - 2], 1);
  }
  const Point across{-bar * (to[1] - from[1]) / length, bar * (to[0] - from[0]) / length};
  add_line(svg, from, to, "edge");
  for (const Point& end : {from, to})
    add_line(svg, {end[0] - across[0], end[1] - across[1]}, {end[0] + across[0], end[1] + across[1]}, "edge");
  labels.avoid(from, to, 2.5);
  labels.symbol({midpoint(from, to)}, name, {});
}

void add_named_turn(const Element& svg, Point centre, double radius, const std::string& name, PictureLabels& labels) {
  constexpr int steps = 12;
  constexpr double half = 0.7;  // of the arc, in radians from the point above the centre
  const double side = radius < 0 ? 1 : -1;
  std::vector<Pixel> arc;
  for (int i = 0; i <= steps; ++i) {
    const double angle = side * half * (2.0 * i / steps - 1);
    arc.push_back({centre[0] + std::abs(radius) * std::sin(angle), centre[1] - std::abs(radius) * std::cos(angle)});
  }
  svg.add("path", "acceleration").set("style", "fill:none").set("d", path_of(arc));
  const Pixel end = arc.back();
  const double right = side * std::cos(half), down = std::sin(half);
  add_arrow(svg, {end.x - 2 * right, end.y - 2 * down}, 8 * right, 8 * down, "acceleration");
  for (std::size_t i = 1; i < arc.size(); ++i) labels.avoid({arc[i - 1].x, arc[i - 1].y}, {arc[i].x, arc[i].y}, 2.5);
  labels.symbol({{end.x, end.y}, {centre[0], centre[1] - std::abs(radius)}}, name, {});
}

}  // namespace slipproof
