#include "report/planes/cone_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/number/format.hpp"
#include "report/markup/number.hpp"
#include "report/markup/symbol.hpp"
#include "report/picture/labels/label_placer.hpp"

namespace slipproof {

namespace {

constexpr double picture_side = 520, picture_margin = 34, band_height = 330;
constexpr std::size_t named_points = 500;  // up to so many points each have a text; with more, the file would be large

/// Maps r_T / (mu r_N) to places in the picture.
class ConePlot {
 public:
  explicit ConePlot(const ConeDisc& disc) : disc_(disc) {
    if (disc.law != FrictionLaw::cone || disc.right_for) reach_ = widest;
    for (const ConePoint& point : disc.points) reach_ = std::clamp(size_of(point) + 0.05, reach_, widest);
  }

  bool flat() const { return disc_.dimension == 2; }
  double height() const { return flat() ? band_height : picture_side; }
  double reach() const { return reach_; }
  double unit() const { return (picture_side / 2 - picture_margin) / reach_; }
  Point center() const { return {picture_side / 2, flat() ? top() : picture_side / 2}; }
  double top() const { return 14; }
  double bottom() const { return height() - 46; }
  bool beyond(const ConePoint& point) const { return size_of(point) > reach_; }

  Point place(const ConePoint& point) const {
    const double size = size_of(point), inwards = size > reach_ ? reach_ / size : 1;
    const double x = center()[0] + unit() * inwards * point.at[0];
    if (!flat()) return {x, center()[1] - unit() * inwards * point.at[1]};
    const double down = (static_cast<double>(point.contact) + 0.5) / static_cast<double>(disc_.contacts);
    return {x, top() + down * (bottom() - top())};
  }

  /// Points are small if there are many.
  double radius(const ConePoint& point) const {
    const double largest = disc_.points.size() <= 60 ? 8 : disc_.points.size() <= 600 ? 5 : 3;
    return largest * (0.5 + 0.5 * std::sqrt(point.size));
  }

 private:
  static constexpr double widest = 1.55;  // a box extends to the square root of 2

  static double size_of(const ConePoint& point) { return std::hypot(point.at[0], point.at[1]); }

  const ConeDisc& disc_;
  double reach_ = 1.15;
};

/// Adds a name as in a formula: r_T1 / (mu r_N).
void add_axis_name(const Element& text, const char* force) {
  text.set("text-anchor", "middle").set("font-size", 15);
  svg_symbol(text, force);
  text.add("tspan").text(" / (");
  svg_symbol(text, "mu r_N");
  text.add("tspan").text(")");
}

void add_line(const Element& svg, std::string_view css_class, const std::string& path) {
  svg.add("path", css_class).set("d", path);
}

/// Draws the boundary of a law, in units from the centre.
void add_boundary(const Element& svg, const ConePlot& plot, FrictionLaw law, std::string_view css_class) {
  const auto [x, y] = plot.center();
  const double unit = plot.unit();
  if (law == FrictionLaw::cone) {
    svg.add("circle", css_class).set("cx", x).set("cy", y).set("r", unit);
  } else if (law == FrictionLaw::box) {
    svg.add("rect", css_class).set("x", x - unit).set("y", y - unit).set("width", 2 * unit).set("height", 2 * unit);
  } else {
    add_line(svg, css_class,
             fmt::format("M{0:.2f},{1:.2f}l{2:.2f},{2:.2f}l-{2:.2f},{2:.2f}l-{2:.2f},-{2:.2f}z", x, y - unit, unit));
  }
}

void add_ticks(const Element& svg, const ConePlot& plot, double y) {
  for (const int value : {-1, 0, 1}) {
    svg.add("text", "soft halo")
        .set("x", plot.center()[0] + value * plot.unit())
        .set("y", y)
        .set("text-anchor", "middle")
        .text(value < 0 ? "−1" : std::to_string(value));
  }
}

void add_disc_frame(const Element& svg, const ConePlot& plot, const ConeDisc& disc) {
  const auto [x, y] = plot.center();
  const double length = plot.reach() * plot.unit();
  add_line(svg, "measure", fmt::format("M{:.2f},{:.2f}h{:.2f}", x - length, y, 2 * length));
  add_line(svg, "measure", fmt::format("M{:.2f},{:.2f}v{:.2f}", x, y - length, 2 * length));
  add_boundary(svg, plot, disc.law, "edge");
  if (disc.law != FrictionLaw::cone) add_boundary(svg, plot, FrictionLaw::cone, "line");
  if (disc.right_for) add_boundary(svg, plot, *disc.right_for, "line");
  add_ticks(svg, plot, picture_side - 22);
  add_axis_name(svg.add("text", "ink").set("x", x).set("y", picture_side - 5), "r_T1");
  add_axis_name(svg.add("text", "ink").set("transform", fmt::format("translate(15 {:.2f}) rotate(-90)", y)), "r_T2");
}

/// Draws the frame for planar contacts: their cones form a band, with the contacts one below the other, the first on
/// top.
void add_band_frame(const Element& svg, const ConePlot& plot, const ConeDisc& disc) {
  const double x = plot.center()[0], height = plot.bottom() - plot.top();
  const auto line = [&](double at, const char* css_class) {
    add_line(svg, css_class, fmt::format("M{:.2f},{:.2f}v{:.2f}", x + at * plot.unit(), plot.top(), height));
  };
  line(0, "measure");
  line(-1, "edge");
  line(1, "edge");
  add_ticks(svg, plot, plot.bottom() + 18);
  add_axis_name(svg.add("text", "ink").set("x", x).set("y", plot.bottom() + 40), "r_T");
  const Element name = svg.add("text", "soft").set("text-anchor", "middle");
  name.set("transform", fmt::format("translate(15 {:.2f}) rotate(-90)", plot.top() + height / 2));
  name.text(disc.contacts == 1 ? "contact 1" : "contacts 1 to " + std::to_string(disc.contacts) + ", downwards");
}

std::string in_cone_words(const ConeDisc& disc, const ConePoint& point) {
  const std::string place = disc.dimension == 2 ? fmt::format("{:.4g}", point.at[0])
                                                : fmt::format("({:.4g}, {:.4g})", point.at[0], point.at[1]);
  return fmt::format("contact {} {}, at {}", point.contact + 1, point.slides ? "slides" : "sticks", place);
}

/// Draws a round point for a contact that sticks, and a triangle around the same place for one that slides.
Element add_point(const Element& parent, Point at, double radius, bool slides) {
  if (!slides) return parent.add("circle").set("cx", at[0]).set("cy", at[1]).set("r", radius);
  const double side = 1.2 * radius;  // so that both have the same visual weight
  return parent.add("path").set(
      "d", fmt::format("M{},{}m0,-{}l{},{}h-{}z", short_number(at[0]), short_number(at[1]), short_number(side),
                       short_number(0.87 * side), short_number(1.5 * side), short_number(1.74 * side)));
}

void add_points(const Element& svg, const ConePlot& plot, const ConeDisc& disc, bool slides) {
  const Element group = svg.add("g", slides ? "points fit-slide" : "points fit-stick");
  group.set("fill-opacity", disc.points.size() <= named_points ? 0.85 : 0.6);
  for (const ConePoint& point : disc.points) {
    if (point.slides != slides) continue;
    const Element shape = add_point(group, plot.place(point), plot.radius(point), slides);
    if (disc.points.size() <= named_points) shape.add("title").text(in_cone_words(disc, point));
  }
}

/// Draws a ring and a number for each of the worst contacts; a number that is far from its ring has a line to it.
void add_marks(const Element& svg, const ConePlot& plot, const ConeDisc& disc) {
  LabelPlacer placer;
  placer.keep_between(24, picture_side - 4);
  std::vector<const ConePoint*> marked;
  for (const ConePoint& point : disc.points) {
    if (!point.marked) continue;
    const auto [x, y] = plot.place(point);
    const double ring = plot.radius(point) + 4;
    placer.avoid(LabelBox{x - ring, y - ring, x + ring, y + ring});
    marked.push_back(&point);
  }
  const Element group = svg.add("g", "marks").set("font-size", 14).set("font-weight", 600);
  for (const ConePoint* point : marked) {
    const Point at = plot.place(*point);
    const double ring = plot.radius(*point) + 4;
    const std::string number = std::to_string(point->contact + 1);
    const LabelBox box = placer.place({at}, 8.5 * static_cast<double>(number.size()) + 2 * ring - 6, 15);
    const double x = (box.left + box.right) / 2, y = (box.top + box.bottom) / 2;
    const double away = std::hypot(x - at[0], y - at[1]), edge = ring / away;
    if (away > ring + 20) {
      add_line(
          group, "measure",
          fmt::format("M{:.2f},{:.2f}L{:.2f},{:.2f}", at[0] + edge * (x - at[0]), at[1] + edge * (y - at[1]), x, y));
    }
    group.add("circle", "new").set("cx", at[0]).set("cy", at[1]).set("r", ring);
    group.add("text", "ink halo").set("x", x).set("y", y + 5).set("text-anchor", "middle").text(number);
  }
}

/// A description for readers who do not see the picture.
std::string words_for_disc(const ConeDisc& disc) {
  std::string text = counted(disc.counts.stick, "contact") + " nearest to sticking, " +
                     counted(disc.counts.slide, "contact") + " nearest to sliding. ";
  text += disc.dimension == 2 ? "Between −1 and 1 a force is inside of its cone."
                              : "In the unit disc a force is inside of its cone.";
  std::string marked;
  for (const ConePoint& point : disc.points) {
    if (point.marked) marked += (marked.empty() ? " Marked as the worst: " : "; ") + in_cone_words(disc, point);
  }
  return text + marked + (marked.empty() ? "" : ".");
}

}  // namespace

Element add_cone_disc(const Element& parent, const ConeDisc& disc, const std::string& id) {
  const ConePlot plot(disc);
  const Element svg = parent.add("svg", "cone-disc").set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
  svg.set("viewBox", fmt::format("0 0 {} {}", short_number(picture_side), short_number(plot.height())))
      .set("font-size", 13);
  svg.set("aria-labelledby", id + "-title " + id + "-text");
  svg.set("data-plot", fmt::format("{} {} {}", plot.center()[0], plot.center()[1], plot.unit()));
  svg.add("title").set("id", id + "-title").text("Forces of the contacts in their friction cones");
  svg.add("desc").set("id", id + "-text").text(words_for_disc(disc));
  if (plot.flat()) {
    add_band_frame(svg, plot, disc);
  } else {
    add_disc_frame(svg, plot, disc);
  }
  add_points(svg, plot, disc, false);
  add_points(svg, plot, disc, true);
  add_marks(svg, plot, disc);
  return svg;
}

bool is_beyond(const ConeDisc& disc, const ConePoint& point) {
  return ConePlot(disc).beyond(point);
}

std::string_view fill_class(ConeSign sign) {
  constexpr std::array<std::string_view, 4> classes{"fit-open", "fit-stick", "fit-slide", "fit-smooth"};
  return classes[static_cast<std::size_t>(sign)];
}

Element add_swatch(const Element& parent, ConeSign sign) {
  const Element svg = parent.add("svg", "swatch").set("viewBox", "0 0 28 18").set("aria-hidden", "true");
  switch (sign) {
    case ConeSign::stick:
    case ConeSign::slide:
      add_point(svg.add("g", fill_class(sign)), {14, 9}, 6, sign == ConeSign::slide);
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
    default:
      add_line(svg, sign == ConeSign::law ? "edge" : "line", "M1,9H27");
      break;
  }
  return svg;
}

}  // namespace slipproof
