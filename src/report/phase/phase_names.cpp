#include "report/phase/phase_names.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "base/number/binary64.hpp"
#include "report/markup/symbol.hpp"
#include "report/picture/polyline.hpp"

namespace slipproof {

namespace {

/// Finds the roomiest place for a label of this width: updates `best` if the label fits more often than before.
void find_room(const Strip& strip, const Frame& frame, double width, double& room, Pixel& best) {
  const auto lower = frame.to_picture(strip.lower), upper = frame.to_picture(strip.upper);
  const double top = frame.top, bottom = frame.top + frame.height;
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const double high = std::max(upper[i].y, top), low = std::min(lower[i].y, bottom);
    const double middle = (high + low) / 2;
    double left = lower[i].x, right = lower[i].x;
    const auto fits = [&](std::size_t k) { return upper[k].y < middle - 9 && lower[k].y > middle + 9; };
    for (std::size_t k = i; k < lower.size() && fits(k); ++k) right = lower[k].x;
    for (std::size_t k = i + 1; k-- > 0 && fits(k);) left = lower[k].x;
    const double across = 2 * std::min(right - lower[i].x, lower[i].x - left) / width, up = (low - high) / 22;
    const double here = std::min(across, up);
    if (here > room) room = here, best = {lower[i].x, middle};
  }
}

}  // namespace

void add_region_names(const Element& plot, const PhaseRegions& regions, const Frame& frame) {
  for (const MotionSet& set : regions.sets) {
    const std::string label = set.motions.size() > 1 ? std::to_string(set.motions.size()) + " motions" : name(set);
    const double width = 7.2 * static_cast<double>(label.size()) + 14;
    Pixel best{0, 0};
    double room = 1;
    for (const Strip& strip : regions.strips) {
      if (strip.set == set) find_room(strip, frame, width, room, best);
    }
    if (room <= 1) continue;
    plot.add("text", "ink name").set("x", best.x).set("y", best.y + 4).set("text-anchor", "middle").text(label);
  }
}

void add_curve_names(const Element& plot, const Plane& plane, const PhaseRegions& regions, const Frame& frame) {
  for (std::size_t c = 0; c < plane.curves.size(); ++c) {
    std::vector<Pixel> best;
    double longest = 0;
    for (const PhaseLine& line : regions.lines) {
      if (line.curve != c) continue;
      const auto visible = frame.visible(frame.to_picture(line.points));
      const double length = length_of(visible) * (line.kind == PhaseLine::Kind::idle ? 0.2 : 1);
      if (length > longest) longest = length, best = visible;
    }
    if (longest < 12) continue;
    const Pixel at = best[best.size() / 2];
    const Element text = plot.add("text", "ink halo").set("x", at.x + 5).set("y", at.y - 6).set("font-size", 15);
    svg_symbol(text, plane.curves[c]);
  }
}

void add_line_names(const Element& plot, const Plane& plane, const Frame& frame) {
  std::vector<const Plane::Line*> lines;
  for (const Plane::Line& line : plane.lines) {
    if (plane.x.from < line.x && line.x < plane.x.to) lines.push_back(&line);
  }
  std::sort(lines.begin(), lines.end(), [](const auto* a, const auto* b) { return a->x < b->x; });
  double before = -1e9, y = 0;
  for (const Plane::Line* line : lines) {
    const double x = frame.x_of(nearest_binary64(line->x));
    y = x - before < 60 ? y + 16 : frame.top + 15;
    before = x;
    const Element text = plot.add("text", "ink halo").set("x", x + 5).set("y", y).set("font-size", 13);
    svg_symbol(text, line->symbol);
    if (line->misprint) text.add("tspan").set("font-size", 11).text(" as printed");
  }
}

}  // namespace slipproof
