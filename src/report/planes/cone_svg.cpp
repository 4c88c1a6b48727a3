#include "report/planes/cone_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number/format.hpp"
#include "report/markup/number.hpp"
#include "report/markup/symbol.hpp"
#include "report/picture/labels/label_placer.hpp"
#include "report/planes/cone_signs.hpp"

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
    const Point inside = in_disc(center(), unit() * inwards, point.at);
    if (!flat()) return inside;
    const double down = (static_cast<double>(point.contact) + 0.5) / static_cast<double>(disc_.contacts);
    return {inside[0], top() + down * (bottom() - top())};
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
  add_cone_axes(svg, plot.center(), plot.reach() * plot.unit());
  add_boundary(svg, plot.center(), plot.unit(), disc.law, "edge");
  if (disc.law != FrictionLaw::cone) add_boundary(svg, plot.center(), plot.unit(), FrictionLaw::cone, "line");
  if (disc.right_for) add_boundary(svg, plot.center(), plot.unit(), *disc.right_for, "line");
  add_ticks(svg, plot, picture_side - 22);
  add_axis_name(svg.add("text", "ink").set("x", x).set("y", picture_side - 5), "r_T1");
  add_axis_name(svg.add("text", "ink").set("transform", fmt::format("translate(15 {:.2f}) rotate(-90)", y)), "r_T2");
}

/// Draws the frame for planar contacts: their cones form a band, with the contacts one below the other, the first on
/// top.
void add_band_frame(const Element& svg, const ConePlot& plot, const ConeDisc& disc) {
  const double x = plot.center()[0], height = plot.bottom() - plot.top();
  const auto line = [&](double at, const char* css_class) {
    add_path(svg, css_class, fmt::format("M{:.2f},{:.2f}v{:.2f}", x + at * plot.unit(), plot.top(), height));
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

void add_points(const Element& svg, const ConePlot& plot, const ConeDisc& disc, bool slides) {
  const Element group = svg.add("g", slides ? "points fit-slide" : "points fit-stick");
  group.set("fill-opacity", disc.points.size() <= named_points ? 0.85 : 0.6);
  for (const ConePoint& point : disc.points) {
    if (point.slides != slides) continue;
    const Element shape = add_cone_point(group, plot.place(point), plot.radius(point), slides);
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
      add_path(
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

}  // namespace slipproof
