#include "picture/bicycle_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "markup/number.hpp"
#include "number/binary64.hpp"
#include "number/format.hpp"
#include "typeset/symbol.hpp"

namespace slipproof {

namespace {

constexpr double width = 360, height = 300, road = 206, longest_arrow = 88, raise = 18;

/// An exact value that fits beside an arrow, or a decimal.
std::string label_value(const Rational& x) {
  std::string text = exact_text(x);
  if (text.size() > 9) text = "≈ " + decimal_text(x, 4);
  if (const std::size_t minus = text.find('-'); minus != text.npos) text.replace(minus, 1, "−");
  return text;
}

/// Whether a motion takes a wheel off the road.
struct Raised {
  bool rear = false, front = false;

  static Raised by(const FoundMotion<Rational>& motion) {
    return {motion.values[Quantity::gap2] > 0, motion.values[Quantity::gap3] > 0};
  }
};

class BicycleDrawing {
 public:
  BicycleDrawing(const Element& svg, const Scene& scene, Raised raised) : svg_(svg), scene_(scene), raised_(raised) {
    const Bicycle<Rational>& p = scene.bicycle;
    R_ = number(p.R), h0_ = number(p.h) + R_, b2_ = number(p.b2), b3_ = number(p.b3);
    const double left = std::min({-b2_ - R_, 0.0}), right = std::max({b3_ + R_, 0.0});
    const double top = std::max(h0_, 2 * R_);
    scale_ = std::min((width - 110) / (right - left), (road - 46 - raise) / top);
    x0_ = width / 2 - scale_ * (left + right) / 2;
    // A raised wheel is as high as can be seen: the other one stays, and the frame turns about its axle.
    const double tilt = std::asin(std::min(0.5, raise / (scale_ * (b2_ + b3_))));
    if (raised_.rear != raised_.front) tilt_ = raised_.front ? tilt : -tilt;
    if (raised_.rear && raised_.front) shift_ = raise;
  }

  void bicycle() const {
    line(16, road, width - 16, road, "frame");
    wheel(-b2_, raised_.rear);
    wheel(b3_, raised_.front);
    // The frame hangs from the hinges up to C; a sprocket between them carries the pedal.
    const double crank = (b3_ - b2_) / 2;
    polygon({{-b2_, R_}, {crank, R_}, {0, h0_}, {-b2_, R_}});
    polygon({{crank, R_}, {b3_, R_}, {0, h0_}});
    const auto [cx, cy] = place(0, h0_);
    svg_.add("circle", "paper body").set("cx", cx).set("cy", cy).set("r", 5);
    svg_.add("circle", "ink").set("cx", cx).set("cy", cy).set("r", 1.8);
  }

  void forces(const FoundMotion<Rational>& motion) {
    using enum Quantity;
    const auto& v = motion.values;
    const Rational weight = scene_.bicycle.M * scene_.road.g;
    const Rational F = scene_.F.value_or(Rational(0));
    Rational largest = abs(weight);
    for (const Rational& force : {v[N2], v[N3], v[S2], v[S3], F}) largest = std::max(largest, Rational(abs(force)));
    unit_ = longest_arrow / number(largest);

    const double rear = x(-b2_), front = x(b3_), below = road + 6;
    // Labels of both wheels stand on lines of their own: contacts may be close to each other.
    normal(rear, v[N2], "N2", -1);
    normal(front, v[N3], "N3", +1);
    tangential(rear, below, v[S2], "S2", -1);
    tangential(front, below, v[S3], "S3", +1);
    if (raised_.rear) gap(rear, v[gap2], "gap2", -1);
    if (raised_.front) gap(front, v[gap3], "gap3", +1);
    const auto [cx, cy] = place(0, h0_);
    arrow(cx, cy + 6, 0, number(weight) * unit_, "load");
    label(cx + 7, cy + 6 + number(weight) * unit_ / 2, "Mg", weight, "start", "ink");
    pedal(F);
    acceleration(v[a]);
  }

 private:
  static double number(const Rational& x) { return nearest_binary64(x); }
  double x(double metres) const { return x0_ + scale_ * metres; }
  double y(double metres) const { return road - scale_ * metres; }
  /// Where a point of the bicycle is drawn.
  std::array<double, 2> place(double across, double up) const {
    const double pivot = raised_.front ? -b2_ : b3_;
    const double dx = scale_ * (across - pivot), dy = scale_ * (up - R_);
    return {x(pivot) + dx * std::cos(tilt_) - dy * std::sin(tilt_),
            y(R_) - dx * std::sin(tilt_) - dy * std::cos(tilt_) - shift_};
  }

  void line(double x1, double y1, double x2, double y2, const char* css_class) const {
    svg_.add("line", css_class).set("x1", x1).set("y1", y1).set("x2", x2).set("y2", y2);
  }
  /// A raised wheel leaves a trace where it stood.
  void wheel(double at, bool is_raised) const {
    const auto [cx, cy] = place(at, R_);
    if (is_raised) svg_.add("circle", "curve").set("cx", x(at)).set("cy", y(R_)).set("r", scale_ * R_);
    svg_.add("circle", "body").set("cx", cx).set("cy", cy).set("r", scale_ * R_);
    svg_.add("circle", "ink").set("cx", cx).set("cy", cy).set("r", 2.5);
  }
  void polygon(const std::vector<std::array<double, 2>>& points) const {
    std::string d;
    for (const auto& p : points) {
      const auto [px, py] = place(p[0], p[1]);
      d += (d.empty() ? "M" : "L") + short_number(px) + "," + short_number(py);
    }
    svg_.add("path", "body").set("d", d);
  }

  /// From a point along (dx, dy), which is also where the tip is.
  void arrow(double x1, double y1, double dx, double dy, const char* css_class) const {
    const double length = std::hypot(dx, dy);
    if (length < 1) return;
    const double ux = dx / length, uy = dy / length, head = std::min(8.0, length);
    const double bx = x1 + dx - head * ux, by = y1 + dy - head * uy, w = head * 0.45;
    const Element group = svg_.add("g", css_class);
    group.add("line").set("x1", x1).set("y1", y1).set("x2", bx).set("y2", by);
    group.add("path")
        .set("stroke", "none")
        .set("d", fmt::format("M{:.2f},{:.2f}L{:.2f},{:.2f}L{:.2f},{:.2f}Z", x1 + dx, y1 + dy, bx - w * uy, by + w * ux,
                              bx + w * uy, by - w * ux));
  }

  void label(double at_x, double at_y, std::string_view symbol, const Rational& value, const char* anchor,
             const char* css_class) const {
    const Element text = svg_.add("text", css_class).set("x", at_x).set("y", at_y).set("text-anchor", anchor);
    text.set("class", std::string(css_class) + " halo").set("font-size", 13);
    svg_symbol(text, symbol);
    text.add("tspan").text(" = " + label_value(value));
  }

  /// The reaction pushes up from below the road; its label stands beside it, away from the other wheel.
  void normal(double at, const Rational& N, std::string_view symbol, int side) const {
    const double length = number(N) * unit_;
    arrow(at, road + 4 + length, 0, -length, "normal");
    label(at + side * 9, road + 44, symbol, N, side < 0 ? "end" : "start", "ink");
  }

  void tangential(double at, double level, const Rational& S, std::string_view symbol, int side) const {
    arrow(at, level, number(S) * unit_, 0, "friction");
    label(at + side * 9, road + 64, symbol, S, side < 0 ? "end" : "start", "ink");
  }

  /// The acceleration with which a wheel leaves the road.
  void gap(double at, const Rational& acceleration, std::string_view symbol, int side) const {
    label(at + side * 9, road + 84, symbol, acceleration, side < 0 ? "end" : "start", "ink");
  }

  /// The pedal force acts along -x, L below the axles' line.
  void pedal(const Rational& F) const {
    const double crank = (b3_ - b2_) / 2, arm = number(scene_.bicycle.L);
    const auto [hx, hy] = place(crank, R_);
    const auto [px, low] = place(crank, R_ - arm);
    const double py = std::clamp(low, 20.0, road - 1);
    line(hx, hy, px, py, "frame");
    arrow(px, py, -number(F) * unit_, 0, "load");
    const bool inside = scene_.force_kind == ForceKind::internal;
    const Element text = svg_.add("text", "ink halo").set("x", width - 12).set("y", 20).set("font-size", 13);
    text.set("text-anchor", "end");
    svg_symbol(text, "F");
    text.add("tspan").text(" = " + label_value(F) + (inside ? " (internal)" : " (external)"));
  }

  void acceleration(const Rational& a) const {
    const double length = a > 0 ? 34 : a < 0 ? -34 : 0;
    const auto [cx, cy] = place(0, h0_);
    arrow(cx + (a > 0 ? 10 : -10), cy - 2, length, 0, "normal");
    label(12, 20, "a", a, "start", "ink");
  }

  const Element svg_;
  const Scene& scene_;
  const Raised raised_;
  double tilt_ = 0, shift_ = 0;
  double R_ = 1, h0_ = 1, b2_ = 1, b3_ = 1, scale_ = 1, x0_ = 0, unit_ = 1;
};

}  // namespace

Element add_bicycle(const Element& parent, const Scene& scene, const FoundMotion<Rational>* motion,
                    std::string_view title) {
  const Element svg = parent.add("svg", "bicycle").set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
  svg.set("viewBox", fmt::format("0 0 {} {}", width, height));
  const Raised raised = motion == nullptr ? Raised{} : Raised::by(*motion);
  const std::string_view off = raised.rear && raised.front ? "; both wheels are raised"
                               : raised.rear               ? "; the rear wheel is raised"
                               : raised.front              ? "; the front wheel is raised"
                                                           : "";
  svg.set("aria-label", std::string(title) + std::string(off));
  BicycleDrawing drawing(svg, scene, raised);
  drawing.bicycle();
  if (motion != nullptr) drawing.forces(*motion);
  return svg;
}

}  // namespace slipproof
