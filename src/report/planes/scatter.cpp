#include "report/planes/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "report/markup/number.hpp"

namespace slipproof {

namespace {

constexpr double left = 76, right = 20, top = 16, bottom = 50;

/// Powers of ten from low to high, both integers.
struct Decades {
  int low = 0, high = 1;

  void include(double value) {
    low = std::min(low, static_cast<int>(std::floor(std::log10(value))));
    high = std::max(high, static_cast<int>(std::ceil(std::log10(value))));
  }
  static Decades of(const std::vector<double>& values) {
    if (values.empty()) return {};
    const int first = static_cast<int>(std::floor(std::log10(values.front())));
    Decades all{first, first + 1};
    for (const double value : values) all.include(value);
    return all;
  }
  int step(double room, double each) const {
    return std::max(1, static_cast<int>(std::ceil((high - low) * each / room)));
  }
};

void add_power(const Element& text, int exponent) {
  text.add("tspan").text("10");
  const std::string digits = (exponent < 0 ? "−" : "") + std::to_string(std::abs(exponent));
  text.add("tspan").set("dy", -5).set("font-size", "75%").text(digits);
}

struct Placed {
  double x, y;
  const Scatter::Dot* dot;
};

}  // namespace

Element add_scatter(const Element& parent, const Scatter& scatter) {
  std::vector<const Scatter::Dot*> dots;
  std::vector<double> xs, ys;
  bool zero = false;
  for (const Scatter::Dot& dot : scatter.dots) {
    if (!(dot.x > 0) || !(dot.y >= 0) || !std::isfinite(dot.x) || !std::isfinite(dot.y)) continue;
    dots.push_back(&dot);
    xs.push_back(dot.x);
    if (dot.y > 0) ys.push_back(dot.y);
    zero = zero || dot.y == 0;
  }
  const Decades across = Decades::of(xs), up = Decades::of(ys);
  const double width = scatter.width - left - right, height = scatter.height - top - bottom, band = zero ? 34 : 0;
  const double plot = height - band;
  const auto x_of = [&](double x) { return left + (std::log10(x) - across.low) / (across.high - across.low) * width; };
  const auto y_of = [&](double y) {
    if (y <= 0) return top + height - band / 2;
    return top + plot - (std::log10(y) - up.low) / (up.high - up.low) * plot;
  };

  const Element svg = parent.add("svg", "scatter").set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
  svg.set("viewBox", fmt::format("0 0 {} {}", short_number(scatter.width), short_number(scatter.height)));
  svg.set("aria-label", scatter.title).set("font-size", 12);
  svg.add("rect", "frame").set("x", left).set("y", top).set("width", width).set("height", height);
  for (int e = across.low; e <= across.high; e += across.step(width, 46)) {
    const double x = x_of(std::pow(10.0, e));
    svg.add("path", "frame").set("d", fmt::format("M{:.2f},{:.2f}v5", x, top + height));
    add_power(svg.add("text", "soft").set("x", x).set("y", top + height + 19).set("text-anchor", "middle"), e);
  }
  for (int e = up.low; e <= up.high; e += up.step(plot, 26)) {
    const double y = y_of(std::pow(10.0, e));
    svg.add("path", "frame").set("d", fmt::format("M{:.2f},{:.2f}h-5", left, y));
    add_power(svg.add("text", "soft").set("x", left - 8).set("y", y + 4).set("text-anchor", "end"), e);
  }
  if (zero) {
    svg.add("path", "curve").set("d", fmt::format("M{:.2f},{:.2f}h{:.2f}", left, top + plot, width));
    svg.add("text", "soft").set("x", left - 8).set("y", y_of(0) + 4).set("text-anchor", "end").text(scatter.zero);
  }
  svg.add("text", "ink")
      .set("x", left + width / 2)
      .set("y", scatter.height - 8)
      .set("text-anchor", "middle")
      .text(scatter.x_name);
  svg.add("text", "ink")
      .set("text-anchor", "middle")
      .set("transform", fmt::format("translate(15 {:.2f}) rotate(-90)", top + height / 2))
      .text(scatter.y_name);

  // Names are next to their dots; a name that would cover another moves up or down a line.
  std::vector<Placed> placed;
  for (const Scatter::Dot* dot : dots) placed.push_back({x_of(dot->x), y_of(dot->y), dot});
  std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.x > b.x; });
  std::vector<std::array<double, 3>> taken;  // from, to, y
  for (const Placed& p : placed) taken.push_back({p.x - 6, p.x + 6, p.y + 4});
  for (const Placed& p : placed) {
    svg.add("circle", p.dot->highlight ? "highlight" : "dot").set("cx", p.x).set("cy", p.y).set("r", 5);
    const double length = 6.6 * static_cast<double>(p.dot->name.size());
    const bool before = p.x + 12 + length > left + width;
    const double from = before ? p.x - 10 - length : p.x + 10;
    double y = p.y + 4;
    for (const double shift : {0.0, -15.0, 15.0, -30.0, 30.0, -45.0}) {
      y = p.y + 4 + shift;
      const auto hides = [&](const auto& t) { return std::abs(t[2] - y) < 13 && from < t[1] && t[0] < from + length; };
      if (y > top + 10 && y < top + height && std::none_of(taken.begin(), taken.end(), hides)) break;
    }
    taken.push_back({from, from + length, y});
    svg.add("text", "ink halo")
        .set("x", before ? p.x - 10 : p.x + 10)
        .set("y", y)
        .set("text-anchor", before ? "end" : "start")
        .text(p.dot->name);
  }
  return svg;
}

}  // namespace slipproof
