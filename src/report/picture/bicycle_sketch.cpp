#include "report/picture/bicycle_sketch.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/number/binary64.hpp"
#include "mechanics/scene/bicycle_scene.hpp"
#include "report/markup/number.hpp"

namespace slipproof {

namespace {

constexpr double raise = 18;
/// A larger sprocket, in radii of a wheel, is drawn this large.
constexpr double largest_sprocket = 0.45;

}  // namespace

BicycleSketch::BicycleSketch(const Element& svg, const MechanismScene& scene, const SketchBox& box, Raised raised)
    : svg_(svg), raised_(raised), width_(box.width), road_(box.road) {
  const auto number = [&](std::string_view symbol) {
    return nearest_binary64(scene.values.parameters[bicycle_parameter(symbol)]);
  };
  R_ = number("R"), h0_ = number("h") + R_, b2_ = number("b2"), b3_ = number("b3");
  r1_ = number("r1"), r2_ = number("r2"), L_ = number("L");
  const double shrink = std::min(1.0, largest_sprocket * R_ / std::max(r1_, r2_));
  r1_ *= shrink, r2_ *= shrink;
  const double left = std::min({-b2_ - R_, 0.0}), right = std::max({b3_ + R_, 0.0});
  const double top = std::max(h0_, 2 * R_);
  scale_ = std::min((box.width - 2 * box.margin) / (right - left), (box.road - box.top - raise) / top);
  x0_ = box.width / 2 - scale_ * (left + right) / 2;
  const double tilt = std::asin(std::min(0.5, raise / (scale_ * (b2_ + b3_))));
  if (raised.rear != raised.front) tilt_ = raised.front ? tilt : -tilt;
  if (raised.rear && raised.front) shift_ = raise;
}

void BicycleSketch::draw() const {
  line({16, road_}, {width_ - 16, road_}, "frame");
  wheel(-b2_, raised_.rear);
  wheel(b3_, raised_.front);
  frame();
  chain();
}

Point BicycleSketch::place(double across, double up) const {
  const double pivot = raised_.front ? -b2_ : b3_;
  const double dx = scale_ * (across - pivot), dy = scale_ * (up - R_);
  return {x(pivot) + dx * std::cos(tilt_) - dy * std::sin(tilt_),
          y(R_) - dx * std::sin(tilt_) - dy * std::cos(tilt_) - shift_};
}

void BicycleSketch::line(Point from, Point to, std::string_view css_class) const {
  svg_.add("line", css_class).set("x1", from[0]).set("y1", from[1]).set("x2", to[0]).set("y2", to[1]);
}

void BicycleSketch::circle(Point centre, double radius, std::string_view css_class) const {
  svg_.add("circle", css_class).set("cx", centre[0]).set("cy", centre[1]).set("r", radius);
}

void BicycleSketch::arrow(Point from, double dx, double dy, std::string_view css_class) const {
  add_arrow(svg_, from, dx, dy, css_class);
}

/// Draws a wheel; a raised one leaves a dotted trace where it was.
void BicycleSketch::wheel(double at, bool is_raised) const {
  if (is_raised) circle({x(at), y(R_)}, scale_ * R_, "curve");
  circle(place(at, R_), scale_ * R_, "body");
  circle(place(at, R_), 2.5, "ink");
}

/// The frame hangs from the hinges up to C; a sprocket between them carries the pedal.
void BicycleSketch::frame() const {
  polygon({{-b2_, R_}, {crank(), R_}, {0, h0_}, {-b2_, R_}});
  polygon({{crank(), R_}, {b3_, R_}, {0, h0_}});
  circle(place(0, h0_), 5, "paper body");
  circle(place(0, h0_), 1.8, "ink");
}

/// Both sprockets, the two runs of the chain, and the crank down to the pedal.
void BicycleSketch::chain() const {
  const double distance = crank() + b2_, rise = (r1_ - r2_) / distance;
  if (std::abs(rise) < 1) {  // the common tangents touch the circles where the radius is perpendicular to them
    const double across = -rise, up = std::sqrt(1 - rise * rise);
    for (const double side : {1.0, -1.0}) {
      line(place(-b2_ + r2_ * across, R_ + side * r2_ * up), place(crank() + r1_ * across, R_ + side * r1_ * up),
           "chain");
    }
  }
  circle(place(-b2_, R_), scale_ * r2_, "chain");
  circle(place(crank(), R_), scale_ * r1_, "chain");
  const Point hub = place(crank(), R_), foot = pedal();
  line(hub, foot, "body");
  line({foot[0] - 7, foot[1]}, {foot[0] + 7, foot[1]}, "body");
}

Point BicycleSketch::pedal() const {
  const Point hub = place(crank(), R_);
  const double room = road_ - hub[1] - 2;
  return {hub[0], hub[1] + std::clamp(scale_ * L_, -room, room)};
}

void BicycleSketch::polygon(std::initializer_list<Point> points) const {
  std::string d;
  for (const Point& p : points) {
    const auto [px, py] = place(p[0], p[1]);
    d += (d.empty() ? "M" : "L") + short_number(px) + "," + short_number(py);
  }
  svg_.add("path", "body").set("d", d);
}

}  // namespace slipproof
