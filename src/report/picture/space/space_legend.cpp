#include "report/picture/space/space_legend.hpp"

#include <string_view>

#include "base/input/utf8.hpp"

namespace slipproof {

namespace {

std::string_view meaning_of(SpaceSign sign) {
  switch (sign) {
    case SpaceSign::normal:
      return "N of a contact";
    case SpaceSign::tangents:
      return "T1 and T2";
    case SpaceSign::force:
      return "force of a contact";
    case SpaceSign::cone:
      return "its friction cone";
    case SpaceSign::open_force:
      return "force that is open: one of its range";
    case SpaceSign::load:
      return "push, weight";
    case SpaceSign::velocity:
      return "velocity";
    case SpaceSign::acceleration:
      return "acceleration";
    case SpaceSign::virtual_rate:
      return "virtual motion";
    case SpaceSign::slip:
      return "where a contact begins to slip";
    case SpaceSign::sliding:
      return "where it slides";
    case SpaceSign::shadow:
      return "shadow, straight down";
  }
  return {};
}

std::string_view meaning_in_impact(SpaceSign sign) {
  switch (sign) {
    case SpaceSign::force:
      return "impulse of a contact";
    case SpaceSign::open_force:
      return "impulse that is open: one of its range";
    case SpaceSign::velocity:
      return "velocity before";
    case SpaceSign::acceleration:
      return "velocity after";
    case SpaceSign::slip:
      return "where a contact slides after";
    default:
      return meaning_of(sign);
  }
}

void add_sample(const Element& svg, SpaceSign sign, double x, double y) {
  const Point from{x, y}, to{x + 26, y};
  switch (sign) {
    case SpaceSign::normal:
      return add_arrow(svg, from, 26, 0, "normal");
    case SpaceSign::tangents:
    case SpaceSign::force:
      return add_arrow(svg, from, 26, 0, "friction");
    case SpaceSign::open_force:
      return add_arrow(svg, from, 26, 0, "friction", ArrowLine::dashed);
    case SpaceSign::load:
      return add_arrow(svg, from, 26, 0, "load");
    case SpaceSign::velocity:
      return add_velocity_arrow(svg, from, to);
    case SpaceSign::acceleration:
    case SpaceSign::virtual_rate:
      return add_acceleration_arrow(svg, from, to);
    case SpaceSign::slip:
      return add_arrow(svg, from, 26, 0, "slips", ArrowLine::dotted);
    case SpaceSign::sliding:
      return add_arrow(svg, from, 26, 0, "slips");
    case SpaceSign::cone:
    case SpaceSign::shadow:
      svg.add("ellipse", sign == SpaceSign::cone ? "cone" : "shadow")
          .set("cx", x + 13)
          .set("cy", y)
          .set("rx", 12)
          .set("ry", 5);
  }
}

}  // namespace

double add_space_legend(const Element& svg, const std::set<SpaceSign>& signs, Point corner, double width,
                        bool is_impact) {
  constexpr double line = 19, letter = 6.6, sample = 32, between = 14;
  const Element group = svg.add("g", "legend");
  double x = corner[0], y = corner[1] + line / 2;
  for (const SpaceSign sign : signs) {
    const std::string_view words = is_impact ? meaning_in_impact(sign) : meaning_of(sign);
    const double needed = sample + letter * static_cast<double>(utf8_count(std::string(words)));
    if (x > corner[0] && x + needed > corner[0] + width) x = corner[0], y += line;
    add_sample(group, sign, x, y);
    group.add("text", "soft").set("x", x + sample).set("y", y + 4).set("font-size", 12).text(words);
    x += needed + between;
  }
  return signs.empty() ? 0 : y + line / 2 - corner[1];
}

void add_velocity_arrow(const Element& svg, Point from, Point to) {
  add_arrow(svg, from, to[0] - from[0], to[1] - from[1], "velocity");
}
void add_acceleration_arrow(const Element& svg, Point from, Point to) {
  add_arrow(svg, from, to[0] - from[0], to[1] - from[1], "acceleration", ArrowLine::dotted);
}

}  // namespace slipproof
