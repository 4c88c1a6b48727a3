#include "report/planes/cone_signs.hpp"

#include <fmt/format.h>

#include <array>

#include "report/markup/number.hpp"

namespace slipproof {

std::string_view fill_class(ConeSign sign) {
  constexpr std::array<std::string_view, 4> classes{"fit-open", "fit-stick", "fit-slide", "fit-smooth"};
  return classes[static_cast<std::size_t>(sign)];
}

void add_path(const Element& svg, std::string_view css_class, const std::string& path) {
  svg.add("path", css_class).set("d", path);
}

void add_cone_axes(const Element& svg, Point center, double length) {
  const auto [x, y] = center;
  add_path(svg, "measure", fmt::format("M{:.2f},{:.2f}h{:.2f}", x - length, y, 2 * length));
  add_path(svg, "measure", fmt::format("M{:.2f},{:.2f}v{:.2f}", x, y - length, 2 * length));
}

void add_boundary(const Element& svg, Point center, double unit, FrictionLaw law, std::string_view css_class) {
  const auto [x, y] = center;
  if (law == FrictionLaw::cone) {
    svg.add("circle", css_class).set("cx", x).set("cy", y).set("r", unit);
  } else if (law == FrictionLaw::box) {
    svg.add("rect", css_class).set("x", x - unit).set("y", y - unit).set("width", 2 * unit).set("height", 2 * unit);
  } else {
    add_path(svg, css_class,
             fmt::format("M{0:.2f},{1:.2f}l{2:.2f},{2:.2f}l-{2:.2f},{2:.2f}l-{2:.2f},-{2:.2f}z", x, y - unit, unit));
  }
}

Point in_disc(Point center, double unit, const std::array<double, 2>& at) {
  return {center[0] + unit * at[0], center[1] - unit * at[1]};
}

Element add_cone_point(const Element& parent, Point at, double radius, bool slides) {
  if (!slides) return parent.add("circle").set("cx", at[0]).set("cy", at[1]).set("r", radius);
  const double side = 1.2 * radius;  // so that both have the same visual weight
  return parent.add("path").set(
      "d", fmt::format("M{},{}m0,-{}l{},{}h-{}z", short_number(at[0]), short_number(at[1]), short_number(side),
                       short_number(0.87 * side), short_number(1.5 * side), short_number(1.74 * side)));
}

Element add_swatch(const Element& parent, ConeSign sign) {
  const Element svg = parent.add("svg", "swatch").set("viewBox", "0 0 28 18").set("aria-hidden", "true");
  switch (sign) {
    case ConeSign::stick:
    case ConeSign::slide:
      add_cone_point(svg.add("g", fill_class(sign)), {14, 9}, 6, sign == ConeSign::slide);
      break;
    case ConeSign::open:
      svg.add("rect", fill_class(sign)).set("x", 6).set("y", 7).set("width", 16).set("height", 4);
      break;
    case ConeSign::smooth:
      svg.add("rect", fill_class(sign)).set("x", 8).set("y", 3).set("width", 12).set("height", 12);
      break;
    case ConeSign::marked:
      svg.add("circle", "new").set("cx", 14).set("cy", 9).set("r", 7);
      break;
    case ConeSign::motion:
      add_arrow(svg, {2, 9}, 24, 0, "moves");
      break;
    case ConeSign::lifts:
    case ConeSign::disc:
      add_boundary(svg, {14, 9}, 7, FrictionLaw::cone, sign == ConeSign::disc ? "edge" : "line");
      break;
    default:
      add_path(svg, sign == ConeSign::law ? "edge" : "line", "M1,9H27");
      break;
  }
  return svg;
}

void add_sign_entry(const Element& list, ConeSign sign, const std::string& meaning) {
  const Element item = list.add("li");
  add_swatch(item, sign);
  item.add("span").text(meaning);
}

}  // namespace slipproof
