#include "report/picture/bicycle_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/number/binary64.hpp"
#include "mechanics/scene/bicycle_scene.hpp"
#include "report/markup/symbol.hpp"
#include "report/picture/bicycle_sketch.hpp"
#include "report/picture/motion_words.hpp"

namespace slipproof {

namespace {

constexpr double width = 360, height = 300, road = 206, longest_arrow = 88;

std::size_t place(const std::vector<std::string>& names, std::string_view symbol) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), symbol) - names.begin());
}
const Rational& acceleration(const MotionAtLoad& motion, std::string_view symbol) {
  return motion.accelerations[place(acceleration_names(bicycle_mechanism()), symbol)];
}
const Range& force(const MotionAtLoad& motion, std::string_view symbol) {
  return motion.forces[place(force_names(bicycle_mechanism()), symbol)];
}
Range exactly(const Rational& x) {
  return {x, x};
}

/// Which wheels a motion takes off the road.
Raised raised_by(const MotionAtLoad& motion) {
  return {acceleration(motion, "gap2") > 0, acceleration(motion, "gap3") > 0};
}

class MotionDrawing {
 public:
  MotionDrawing(const Element& svg, const MechanismScene& scene, Raised raised, NumberWords numbers)
      : svg_(svg),
        scene_(scene),
        raised_(raised),
        numbers_(std::move(numbers)),
        sketch_(svg, scene, {width, 55, 46, road}, raised) {
    sketch_.draw();
  }

  void forces(const MotionAtLoad& motion) {
    const Range N2 = force(motion, "N2"), N3 = force(motion, "N3"), S2 = force(motion, "S2"), S3 = force(motion, "S3");
    const Rational weight = value("M") * value("g");
    const Range F = exactly(scene_.load.value_or(Rational(0)));
    double largest = nearest_binary64(weight);
    for (const Range& one : {N2, N3, S2, S3, F}) largest = std::max(largest, std::abs(number(one)));
    unit_ = longest_arrow / largest;

    const double rear = sketch_.x(-sketch_.b2()), front = sketch_.x(sketch_.b3()), below = road + 6;
    // The labels of the two wheels are on separate lines, since the contacts may be close to each other.
    normal(rear, N2, "N2", -1);
    normal(front, N3, "N3", +1);
    tangential(rear, below, S2, "S2", -1);
    tangential(front, below, S3, "S3", +1);
    if (raised_.rear) gap(rear, slipproof::acceleration(motion, "gap2"), "gap2", -1);
    if (raised_.front) gap(front, slipproof::acceleration(motion, "gap3"), "gap3", +1);
    const auto [cx, cy] = sketch_.place(0, sketch_.h0());
    const double down = nearest_binary64(weight) * unit_;
    sketch_.arrow({cx, cy + 6}, 0, down, "load");
    label(cx + 7, cy + 6 + down / 2, "M g", exactly(weight), "start", "ink");
    pedal(F);
    acceleration(slipproof::acceleration(motion, "a"));
  }

 private:
  static double number(const Range& range) { return nearest_binary64(shown_value(range).value_or(Rational(0))); }
  const Rational& value(std::string_view symbol) const { return scene_.values.parameters[bicycle_parameter(symbol)]; }
  /// Adds a label next to a point; a long value is moved into the picture.
  void label(double at_x, double at_y, std::string_view symbol, const Range& value, std::string_view anchor,
             std::string_view css_class) const {
    const std::string number = numbers_.range(value);
    const double length = 7.0 * static_cast<double>(number.size() + symbol.size()), edge = 4;
    if (anchor == "start" && at_x + length > width - edge) at_x = width - edge, anchor = "end";
    if (anchor == "end" && at_x - length < edge && at_x < width / 2) at_x = edge, anchor = "start";
    const Element text = svg_.add("text", std::string(css_class) + " halo").set("x", at_x).set("y", at_y);
    text.set("text-anchor", anchor).set("font-size", 13);
    svg_symbol(text, symbol);
    text.add("tspan").set("dx", 4).text(number);
  }

  /// Draws the reaction, which pushes up from below the road. Its label is next to it, away from the other wheel.
  void normal(double at, const Range& N, std::string_view symbol, int side) const {
    const double length = number(N) * unit_;
    sketch_.arrow({at, road + 4 + length}, 0, -length, "normal");
    label(at + side * 9, road + 44, symbol, N, side < 0 ? "end" : "start", "ink");
  }

  void tangential(double at, double level, const Range& S, std::string_view symbol, int side) const {
    sketch_.arrow({at, level}, number(S) * unit_, 0, "friction");
    label(at + side * 9, road + 64, symbol, S, side < 0 ? "end" : "start", "ink");
  }

  /// Draws the acceleration with which a wheel leaves the road.
  void gap(double at, const Rational& acceleration, std::string_view symbol, int side) const {
    label(at + side * 9, road + 84, symbol, exactly(acceleration), side < 0 ? "end" : "start", "ink");
  }

  /// Draws the pedal force, which acts along -x at the pedal.
  void pedal(const Range& F) const {
    const Point at = sketch_.pedal();
    sketch_.arrow(at, -number(F) * unit_, 0, "load");
    if (!F.lower->is_zero()) {  // the value is written elsewhere: there is no room for it near the pedal
      const Element name = svg_.add("text", "ink halo").set("x", at[0] + 10).set("y", at[1] + 4).set("font-size", 13);
      svg_symbol(name, "F");
    }
    const Element text = svg_.add("text", "ink halo").set("x", width - 12).set("y", 20).set("font-size", 13);
    text.set("text-anchor", "end");
    svg_symbol(text, "F");
    text.add("tspan").set("dx", 4).text(numbers_.value(*F.lower) +
                                        (value("external").is_zero() ? " (internal)" : " (external)"));
  }

  /// The arrow is that of M a, to scale with the forces.
  void acceleration(const Rational& a) const {
    const double length = nearest_binary64(Rational(value("M") * a)) * unit_;
    const auto [cx, cy] = sketch_.place(0, sketch_.h0());
    sketch_.arrow({cx + (a > 0 ? 10 : -10), cy - 2}, length, 0, "normal");
    label(12, 20, "a", exactly(a), "start", "ink");
  }

  const Element svg_;
  const MechanismScene& scene_;
  const Raised raised_;
  const NumberWords numbers_;
  const BicycleSketch sketch_;
  double unit_ = 1;
};

}  // namespace

std::vector<Range> bicycle_numbers(const MechanismScene& scene, const MotionAtLoad* motion) {
  if (motion == nullptr) return {};
  const auto& values = scene.values.parameters;
  std::vector<Range> shown{exactly(scene.load.value_or(Rational(0))),
                           exactly(values[bicycle_parameter("M")] * values[bicycle_parameter("g")]),
                           exactly(acceleration(*motion, "a"))};
  for (const char* symbol : {"N2", "N3", "S2", "S3"}) shown.push_back(force(*motion, symbol));
  for (const char* symbol : {"gap2", "gap3"}) shown.push_back(exactly(acceleration(*motion, symbol)));
  return shown;
}

Element add_bicycle(const Element& parent, const MechanismScene& scene, const MotionAtLoad* motion,
                    std::string_view title, const std::optional<NumberWords>& numbers) {
  const Element svg = parent.add("svg", "bicycle").set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
  svg.set("viewBox", fmt::format("0 0 {} {}", width, height));
  const Raised raised = motion == nullptr ? Raised{} : raised_by(*motion);
  const std::string_view off = raised.rear && raised.front ? "; both wheels are raised"
                               : raised.rear               ? "; the rear wheel is raised"
                               : raised.front              ? "; the front wheel is raised"
                                                           : "";
  svg.set("aria-label", std::string(title) + std::string(off));
  MotionDrawing drawing(svg, scene, raised, numbers ? *numbers : NumberWords(bicycle_numbers(scene, motion)));
  if (motion != nullptr) drawing.forces(*motion);
  return svg;
}

}  // namespace slipproof
