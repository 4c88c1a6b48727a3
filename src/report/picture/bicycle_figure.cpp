#include "report/picture/bicycle_figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "report/markup/symbol.hpp"
#include "report/picture/bicycle_sketch.hpp"
#include "report/picture/palette.hpp"

namespace slipproof {

namespace {

constexpr double figure_width = 760, figure_height = 520, figure_road = 398, margin = 96, figure_top = 34;

constexpr std::string_view description =
    "The bicycle from the side. The x axis points forward, the y axis down; a turn is positive clockwise, from x "
    "towards y. C is the centre of mass of everything, at the height h0 above the road and h above the line of the "
    "axles O2 and O3, the distances b2 and b3 in front of the rear and behind the front contact. R is the radius of "
    "the "
    "wheels, r1 and r2 those of the sprockets that the chain joins. The pedal is the arm L below the line of the "
    "axles; a positive force F pulls it backwards. The road pushes the wheels up with N2 and N3, and forwards with S2 "
    "and S3 where these are positive.";

class LabelledFigure {
 public:
  LabelledFigure(const Element& svg, const MechanismScene& scene)
      : svg_(svg), sketch_(svg, scene, {figure_width, margin, figure_top, figure_road}) {}

  void draw() const {
    axle_line();
    sketch_.draw();
    heights();
    distances();
    radii();
    pedal();
    reactions("N2", "S2", -sketch_.b2());
    reactions("N3", "S3", sketch_.b3());
    centre();
    turns();
    axes({figure_width - 128, 46});
  }

 private:
  double rear_edge() const { return sketch_.x(-sketch_.b2() - sketch_.R()); }

  void symbol(Point at, std::string_view name, const char* anchor = "middle") const {
    const Element text = svg_.add("text", "ink halo").set("x", at[0]).set("y", at[1]).set("text-anchor", anchor);
    svg_symbol(text.set("font-size", 16), name);
  }
  void words(Point at, std::string_view what, const char* anchor) const {
    const Element text = svg_.add("text", "soft halo").set("x", at[0]).set("y", at[1]).set("text-anchor", anchor);
    text.set("font-size", 12).text(what);
  }

  /// Draws a measured length: a line with a bar at both ends.
  void measure(Point from, Point to) const {
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    if (length < 1) return;
    const double bar_x = -4 * (to[1] - from[1]) / length, bar_y = 4 * (to[0] - from[0]) / length;
    sketch_.line(from, to, "edge");
    for (const Point& end : {from, to}) {
      sketch_.line({end[0] - bar_x, end[1] - bar_y}, {end[0] + bar_x, end[1] + bar_y}, "edge");
    }
  }
  /// Draws part of a circle with an arrow at its end. A positive turn is clockwise; angles are measured clockwise from
  /// the x axis.
  void turn(Point centre, double radius, double from_degrees, double to_degrees, std::string_view css_class) const {
    const auto at = [&](double degrees) {
      const double angle = degrees * std::numbers::pi / 180;
      return Point{centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)};
    };
    const Point start = at(from_degrees), end = at(to_degrees);
    svg_.add("path", css_class)
        .set("fill", "none")
        .set("style", "fill:none")
        .set("d", fmt::format("M{:.2f},{:.2f}A{:.2f},{:.2f} 0 0 1 {:.2f},{:.2f}", start[0], start[1], radius, radius,
                              end[0], end[1]));
    const double angle = to_degrees * std::numbers::pi / 180;
    sketch_.arrow({end[0] + 2 * std::sin(angle), end[1] - 2 * std::cos(angle)}, -8 * std::sin(angle),
                  8 * std::cos(angle), css_class);
  }

  void axle_line() const {
    const double y = sketch_.y(sketch_.R());
    sketch_.line({rear_edge() - 62, y}, {sketch_.x(sketch_.b3() + sketch_.R()), y}, "curve");
    symbol({sketch_.x(-sketch_.b2()) - 16, y - 10}, "O2");
    symbol({sketch_.x(sketch_.b3()) + 4, y + 20}, "O3");
  }

  void heights() const {
    const double centre = sketch_.y(sketch_.h0()), axles = sketch_.y(sketch_.R()), x = rear_edge();
    sketch_.line({x - 62, centre}, {sketch_.x(0) - 8, centre}, "curve");
    measure({x - 14, axles}, {x - 14, centre});
    symbol({x - 22, (axles + centre) / 2 + 5}, "h", "end");
    measure({x - 52, figure_road}, {x - 52, centre});
    symbol({x - 60, (figure_road + centre) / 2 + 5}, "h0", "end");
  }

  void distances() const {
    const double level = figure_road + 88, rear = sketch_.x(-sketch_.b2()), front = sketch_.x(sketch_.b3()),
                 c = sketch_.x(0);
    for (const double x : {rear, front}) sketch_.line({x, figure_road + 64}, {x, level + 8}, "curve");
    sketch_.line({c, sketch_.y(sketch_.h0()) + 70}, {c, level + 8}, "curve");
    measure({rear, level}, {c, level});
    measure({c, level}, {front, level});
    symbol({(rear + c) / 2, level + 22}, "b2");
    symbol({(c + front) / 2, level + 22}, "b3");
  }

  void radii() const {
    radius(sketch_.b3(), sketch_.R(), -40, "R", 0.6);
    radius(sketch_.crank(), sketch_.r1(), -130, "r1", 1.5);
    radius(-sketch_.b2(), sketch_.r2(), 130, "r2", 2.2);
  }
  /// Draws a radius outwards from a hinge; the label is next to the line at this fraction of its length.
  void radius(double hinge, double length, double degrees, std::string_view name, double label_at) const {
    const double angle = degrees * std::numbers::pi / 180, pixels = sketch_.scale() * length;
    const Point from = sketch_.place(hinge, sketch_.R());
    const auto along = [&](double part) {
      return Point{from[0] + part * pixels * std::cos(angle), from[1] + part * pixels * std::sin(angle)};
    };
    sketch_.line(from, along(1), "edge");
    const Point label = along(label_at);
    symbol({label[0] + (label_at < 1 ? -10 : 0), label[1] + (label_at < 1 ? -6 : 5)}, name);
  }

  void pedal() const {
    const Point at = sketch_.pedal();
    const double hub = sketch_.y(sketch_.R()), arm = at[0] + 30;
    symbol({at[0] + 18, hub - 10}, "O1");
    sketch_.line({at[0] + 10, at[1]}, {arm + 6, at[1]}, "curve");
    measure({arm, hub}, {arm, at[1]});
    symbol({arm + 8, (hub + at[1]) / 2 + 6}, "L", "start");
    sketch_.arrow({at[0] - 8, at[1]}, -62, 0, "friction");
    symbol({at[0] - 52, at[1] - 8}, "F");
    words({at[0], at[1] + 18}, "pedal", "middle");
    const double middle = (sketch_.x(-sketch_.b2()) + at[0]) / 2;
    words({middle + 14, hub - sketch_.scale() * (sketch_.r1() + sketch_.r2()) / 2 - 6}, "chain", "middle");
  }

  void reactions(std::string_view N, std::string_view S, double wheel) const {
    const double x = sketch_.x(wheel);
    sketch_.arrow({x, figure_road + 62}, 0, -58, "normal");
    symbol({x - 8, figure_road + 52}, N, "end");
    sketch_.arrow({x, figure_road}, 60, 0, "friction");
    symbol({x + 58, figure_road + 22}, S);
  }

  void centre() const {
    const auto [x, y] = sketch_.place(0, sketch_.h0());
    symbol({x - 15, y + 18}, "C", "end");
    sketch_.arrow({x + 9, y}, 58, 0, "normal");
    symbol({x + 60, y - 9}, "a");
    sketch_.arrow({x, y + 8}, 0, 56, "load");
    symbol({x - 8, y + 62}, "M g", "end");
  }

  /// Draws angular accelerations: of the frame about C, of the sprocket, and of the wheels.
  void turns() const {
    const auto [x, y] = sketch_.place(0, sketch_.h0());
    turn({x, y}, 24, -150, -40, "normal");
    symbol({x + 4, y - 31}, "phi");
    const double wheel = 0.78 * sketch_.scale() * sketch_.R();
    const auto wheel_turn = [&](double at, std::string_view name) {
      const Point hub = sketch_.place(at, sketch_.R());
      turn(hub, wheel, -125, -75, "normal");
      symbol({hub[0] + 0.34 * wheel + 14, hub[1] - wheel + 16}, name);
    };
    wheel_turn(-sketch_.b2(), "eps2");
    wheel_turn(sketch_.b3(), "eps3");
    const Point hub = sketch_.place(sketch_.crank(), sketch_.R());
    const double r = sketch_.scale() * sketch_.r1() + 9;
    turn(hub, r, -80, -15, "normal");
    symbol({hub[0] + 0.8 * r + 6, hub[1] - 0.8 * r - 2}, "eps1", "start");
  }

  void axes(Point at) const {
    sketch_.arrow(at, 72, 0, "load");
    sketch_.arrow(at, 0, 72, "load");
    symbol({at[0] + 82, at[1] + 5}, "x");
    symbol({at[0], at[1] + 90}, "y");
    turn(at, 36, 12, 74, "load");
    words({at[0] + 34, at[1] + 46}, "positive", "start");
    words({at[0] + 34, at[1] + 60}, "turn", "start");
  }

  const Element svg_;
  const BicycleSketch sketch_;
};

void draw_figure(const Element& svg, const MechanismScene& scene) {
  svg.set("role", "img").set("viewBox", fmt::format("0 0 {} {}", figure_width, figure_height));
  svg.add("title").text("The bicycle of the model with its axes, signs and symbols");
  svg.add("desc").text(description);
  LabelledFigure(svg, scene).draw();
}

}  // namespace

Element add_bicycle_figure(const Element& parent, const MechanismScene& scene) {
  const Element svg = parent.add("svg", "labelled").set("xmlns", "http://www.w3.org/2000/svg");
  draw_figure(svg, scene);
  return svg;
}

std::string bicycle_figure_file(const MechanismScene& scene) {
  const ElementTree document("svg");
  const Element svg = document.root().set("xmlns", "http://www.w3.org/2000/svg");
  svg.set("width", figure_width).set("height", figure_height);
  svg.set("font-family", "system-ui, 'DejaVu Sans', sans-serif");
  svg.add("style").code(picture_style());
  svg.add("rect", "paper").set("width", figure_width).set("height", figure_height).set("rx", 10);
  draw_figure(svg, scene);
  return document.xml();
}

}  // namespace slipproof
