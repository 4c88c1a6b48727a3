#include "report/phase/phase_signs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "report/markup/symbol.hpp"
#include "report/picture/motion_words.hpp"

namespace slipproof {

namespace {

bool is_striped(const MotionSet& set) {
  return set.motions.size() + set.continua.size() > 1;
}

std::string mark_words(const Plane& plane) {
  const NumberWords numbers({{plane.mark->x, plane.mark->x}, {plane.mark->y, plane.mark->y}});
  const auto value = [&](const Axis& axis, const Rational& x) {
    return plain_symbol(axis.symbol) + " " + numbers.value(x) +
           (axis.unit.empty() || axis.unit == "1" ? "" : " " + axis.unit);
  };
  const std::string load = value(plane.y, plane.mark->y);
  return plane.mark->label + ": " + (plane.x.is_angle ? load : value(plane.x, plane.mark->x) + ", " + load);
}

}  // namespace

std::vector<PhaseSign> phase_signs(const PhasePicture& picture) {
  const Plane& plane = picture.diagram.plane;
  const auto& sets = picture.regions.sets;
  std::vector<PhaseSign> signs;
  if (plane.mark) signs.push_back({PhaseSign::Kind::mark, mark_words(plane)});
  if (picture.diagram.raster) {
    signs.push_back({PhaseSign::Kind::place,
                     fmt::format("a place that was solved: {} of {} completely", picture.diagram.raster->complete(),
                                 picture.diagram.raster->places.size())});
  }
  const auto is_edge = [](const PhaseLine& line) { return line.kind == PhaseLine::Kind::edge; };
  if (plane.curves.empty() && std::ranges::any_of(picture.regions.lines, is_edge)) {
    signs.push_back({PhaseSign::Kind::line, "on a line the motions change, or others exist only there"});
  }
  if (std::ranges::any_of(sets, opens)) signs.push_back({PhaseSign::Kind::dots, "dots: a contact opens"});
  if (std::ranges::any_of(sets, is_striped)) {
    signs.push_back({PhaseSign::Kind::stripes, "stripes: several motions, each with its colour"});
  }
  if (!std::ranges::all_of(sets, &MotionSet::complete)) {
    signs.push_back({PhaseSign::Kind::hatching, "hatched: not proved that there are no others"});
  }
  return signs;
}

void draw_sign(const Element& parent, const PhasePicture& picture, const PhaseSign& sign) {
  const auto circle = [&](std::string_view css, double x, double y, double radius) {
    parent.add("circle", css).set("cx", x).set("cy", y).set("r", radius);
  };
  switch (sign.kind) {
    case PhaseSign::Kind::mark:
      circle("ink", 14, 9, 4);
      circle("frame", 14, 9, 8);
      break;
    case PhaseSign::Kind::place:
      circle("ink", 14, 9, 1.2);
      break;
    case PhaseSign::Kind::hatching:
      parent.add("path", "hatching").set("d", "M2,16L16,2M12,16L26,2");
      break;
    case PhaseSign::Kind::line:
      parent.add("path", "edge").set("d", "M1,9H27");
      break;
    case PhaseSign::Kind::dots:
      for (const double x : {5.0, 14.0, 23.0}) circle("dots", x, 9, 1.4);
      break;
    case PhaseSign::Kind::stripes: {
      const auto& sets = picture.regions.sets;
      const auto striped = std::ranges::find_if(sets, is_striped);
      paint_swatch(parent.add("rect"), picture, static_cast<std::size_t>(striped - sets.begin()));
      break;
    }
  }
}

}  // namespace slipproof
