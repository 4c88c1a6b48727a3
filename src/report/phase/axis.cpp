#include "report/phase/axis.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/number/binary64.hpp"
#include "report/markup/symbol.hpp"

namespace slipproof {

std::vector<double> ticks(double from, double to, int count) {
  const double rough = (to - from) / count;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = power;
  for (const double factor : {2.0, 5.0, 10.0}) {
    if (step < rough) step = factor * power;
  }
  std::vector<double> all;
  for (double i = std::ceil(from / step - 1e-9); i * step <= to + step * 1e-9; ++i) all.push_back(i * step);
  return all;
}

namespace {

std::string tick_text(double value) {
  const double rounded = std::abs(value) < 1e-12 ? 0 : value;
  std::string text = fmt::format("{:.6g}", rounded);
  if (text[0] == '-') text.replace(0, 1, "−");
  return text;
}

void add_name(const Element& text, const Axis& axis) {
  svg_symbol(text, axis.symbol);
  if (!axis.unit.empty() && axis.unit != "1")
    text.add("tspan").set("dx", 4).set("font-size", 12).text("in " + axis.unit);
}

double degrees(double tan_half) {
  return 360 / std::numbers::pi * std::atan(tan_half);
}
double tan_half(double degrees) {
  return std::tan(degrees * std::numbers::pi / 360);
}

}  // namespace

Frame::Frame(double left_, double top_, double width_, double height_, const Axis& x, const Axis& y)
    : left(left_),
      top(top_),
      width(width_),
      height(height_),
      x_from_(nearest_binary64(x.from)),
      x_to_(nearest_binary64(x.to)),
      y_from_(nearest_binary64(y.from)),
      y_to_(nearest_binary64(y.to)),
      x_(x),
      y_(y) {}

std::vector<Pixel> Frame::to_picture(const std::vector<PlanePoint>& points) const {
  std::vector<Pixel> pixels;
  pixels.reserve(points.size());
  for (const PlanePoint& point : points) pixels.push_back({x_of(point.x), y_of(point.y)});
  return pixels;
}

std::vector<Pixel> Frame::visible(const std::vector<Pixel>& points) const {
  std::vector<Pixel> best, here;
  for (const Pixel& p : points) {
    const bool inside = p.x >= left && p.x <= left + width - 24 && p.y >= top + 16 && p.y <= top + height;
    if (inside) here.push_back(p);
    if (!inside) here.clear();
    if (here.size() > 1 && length_of(here) > length_of(best)) best = here;
  }
  return best;
}

void Frame::draw(const Element& svg) const {
  const Element axes = svg.add("g").set("font-size", 12);
  axes.add("rect", "frame").set("x", left).set("y", top).set("width", width).set("height", height);
  const auto across = static_cast<int>(width / 80);
  if (x_.is_angle) {
    for (const double value : ticks(degrees(x_from_), degrees(x_to_), across)) {
      draw_tick(axes, x_of(tan_half(value)), tick_text(value) + "°");
    }
  } else {
    for (const double value : ticks(x_from_, x_to_, across)) draw_tick(axes, x_of(value), tick_text(value));
  }
  for (const double value : ticks(y_from_, y_to_, static_cast<int>(height / 55))) {
    const double y = y_of(value);
    axes.add("path", "frame").set("d", fmt::format("M{:.2f},{:.2f}h-5", left, y));
    axes.add("text", "soft").set("x", left - 8).set("y", y + 4).set("text-anchor", "end").text(tick_text(value));
  }
  const Element x_text = axes.add("text", "ink").set("x", left + width / 2).set("y", top + height + 40);
  x_text.set("text-anchor", "middle").set("font-size", 15);
  add_name(x_text, x_);
  const Element y_text = axes.add("text", "ink").set("text-anchor", "middle").set("font-size", 15);
  y_text.set("transform", fmt::format("translate(16 {:.2f}) rotate(-90)", top + height / 2));
  add_name(y_text, y_);
}

void Frame::draw_tick(const Element& axes, double x, const std::string& text) const {
  axes.add("path", "frame").set("d", fmt::format("M{:.2f},{:.2f}v5", x, top + height));
  axes.add("text", "soft").set("x", x).set("y", top + height + 18).set("text-anchor", "middle").text(text);
}

}  // namespace slipproof
