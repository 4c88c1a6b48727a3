#include "report/picture/velocities/moving_outlines.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "report/picture/polyline.hpp"

namespace slipproof {

namespace {

using Outline = MechanismGeometry::Outline;

/// How an outline in pixels gets from its first place to another one: a move, a turn and a stretch.
struct Carried {
  Point from, to;
  double turn = 0, stretch = 1;  ///< in degrees, clockwise as y points down

  /// As CSS writes it, with units, or as the attribute does.
  std::string text(bool css) const {
    const char* const format =
        css ? "translate({:.2f}px,{:.2f}px) rotate({:.3f}deg) scale({:.5f}) translate({:.2f}px,{:.2f}px)"
            : "translate({:.2f},{:.2f}) rotate({:.3f}) scale({:.5f}) translate({:.2f},{:.2f})";
    return fmt::format(fmt::runtime(format), to[0], to[1], turn, stretch, -from[0], -from[1]);
  }
};

Carried carried(const Outline& first, const Outline& later, double turn_before,
                const std::function<Point(Point)>& pixel) {
  Carried result{pixel(first.points[0]), pixel(later.points[0]), turn_before};
  if (first.points.size() < 2) return result;
  const Point a = pixel(first.points[1]), b = pixel(later.points[1]);
  const double ax = a[0] - result.from[0], ay = a[1] - result.from[1], bx = b[0] - result.to[0],
               by = b[1] - result.to[1];
  if (std::hypot(ax, ay) == 0) return result;
  result.stretch = std::hypot(bx, by) / std::hypot(ax, ay);
  result.turn = (std::atan2(by, bx) - std::atan2(ay, ax)) * 180 / std::numbers::pi;
  result.turn += 360 * std::round((turn_before - result.turn) / 360);  // the turn that is nearest to the frame before
  return result;
}

Element add_outline(const Element& svg, const Outline& outline, double scale,
                    const std::function<Point(Point)>& pixel) {
  const Point at = pixel(outline.points[0]);
  if (outline.kind == MechanismShape::Kind::circle) {
    return svg.add("circle").set("cx", at[0]).set("cy", at[1]).set("r", scale * outline.radius);
  }
  std::vector<Pixel> pixels;
  for (const Point& p : outline.points) pixels.push_back({pixel(p)[0], pixel(p)[1]});
  const bool closed = outline.kind == MechanismShape::Kind::polygon;
  return svg.add("path").set("d", closed ? closed_path_of(pixels) : path_of(pixels));
}

bool is_moving(const Outline& outline) {
  using Kind = MechanismShape::Kind;
  return outline.kind == Kind::polygon || outline.kind == Kind::line || outline.kind == Kind::circle;
}

}  // namespace

void add_moving_outlines(const Element& svg, const std::vector<std::vector<Outline>>& frames, double seconds,
                         double scale, const std::function<Point(Point)>& pixel) {
  constexpr double rest = 3;  // of the seconds in which they move
  std::string style = "@media (prefers-reduced-motion:reduce){.ahead>*{animation:none!important}}\n";
  const Element group = svg.add("g", "moves ahead").set("style", "fill:none;stroke-width:1.4");
  for (std::size_t i = 0; i < frames.front().size(); ++i) {
    const Outline& first = frames.front()[i];
    if (!is_moving(first)) continue;
    std::string keys;
    Carried last{pixel(first.points[0]), pixel(first.points[0])};
    for (std::size_t k = 0; k < frames.size(); ++k) {
      last = carried(first, frames[k][i], last.turn, pixel);
      const double share = 100.0 * static_cast<double>(k) / static_cast<double>(frames.size() - 1) / (1 + rest);
      keys += fmt::format("{:.3g}%{{transform:{}}}", share, last.text(true));
    }
    style += fmt::format("@keyframes ahead{0}{{{1}100%{{transform:{2}}}}}\n", i, keys, last.text(true));
    add_outline(group, first, scale, pixel)
        .set("transform", last.text(false))
        .set("style", fmt::format("animation:ahead{} {:g}s linear infinite", i, seconds * (1 + rest)));
  }
  svg.add("style").code(style);
}

}  // namespace slipproof
