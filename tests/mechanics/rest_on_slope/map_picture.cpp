#include "mechanics/rest_on_slope/map_picture.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "report/markup/element.hpp"
#include "report/picture/palette.hpp"

namespace slipproof::test::rest_on_slope {

namespace {

/// All lengths in pixels, y down. A unit of u and of mu h is `scale`.
constexpr int width = 520, height = 384, left = 44, right = 476, bottom = 320, scale = 216;
constexpr const char* description =
    "The places of bodies: u, how far the centre of mass is down the slope of the middle of the feet, from left to "
    "right, and mu h upwards. Rest is stable in a triangle over u from -1/2 to 1/2, up to mu h = 1/2, if 1/3 <= J <= "
    "2/3 and mu <= 1, at {} points below the lines |u| + mu h = 1, and at one above them.";

std::pair<int, int> place(double u, double mu_h) {
  return {(left + right) / 2 + static_cast<int>(std::lround(scale * u)),
          bottom - static_cast<int>(std::lround(scale * mu_h))};
}

class MapPicture {
 public:
  MapPicture(const std::vector<Point>& points, const Body& tipping) : points_(points), tipping_(tipping) {}

  std::string file() {
    svg_.set("xmlns", "http://www.w3.org/2000/svg").set("role", "img").set("aria-labelledby", "title description");
    svg_.set("font-family", "system-ui, 'DejaVu Sans', sans-serif").set("font-size", 13);
    svg_.set("width", width).set("height", height).set("viewBox", fmt::format("0 0 {} {}", width, height));
    svg_.add("title").set("id", "title").text("Where rest of a body on two feet on a slope is stable");
    svg_.add("desc").set("id", "description").text(fmt::format(description, points_.size()));
    svg_.add("style").code(picture_style());
    svg_.add("rect", "paper").set("width", width).set("height", height);
    text(12, 27, "start", "Rest is stable on every slope below mu").set("font-size", 17);
    triangle(0.5, "fit-stick").set("fill-opacity", "0.35");
    triangle(1, "frame");
    axes();
    words(0, 0.025, "1/3 ≤ J ≤ 2/3, mu ≤ 1");
    words(0.66, 0.83, "beyond: it tips while it slides");
    std::map<std::pair<int, int>, std::string> names;
    for (const Point& point : points_) {
      std::string& here = names[place(point.body.u, point.body.mu * point.body.h)];
      here += (here.empty() ? "" : ", ") + point.id.substr(point.id.find(' ') + 1);
    }
    for (const auto& [at, name] : names) mark(at, "fit-stick", name);
    mark(place(tipping_.u, tipping_.mu * tipping_.h), "fit-slide", "T");
    words(0.88, 0.31, "T: slopes up to 1/10");
    return document_.xml();
  }

 private:
  Element text(int x, int y, const char* anchor, const std::string& written) {
    return svg_.add("text", "ink").set("x", x).set("y", y).set("text-anchor", anchor).text(written);
  }

  void words(double u, double mu_h, const char* written) {
    const auto [x, y] = place(u, mu_h);
    text(x, y, "middle", written).set("font-size", 12);
  }

  /// |u| + mu h <= limit.
  Element triangle(double limit, const char* css_class) {
    const auto [x, y] = place(-limit, 0);
    const int size = static_cast<int>(std::lround(scale * limit));
    return svg_.add("path", css_class).set("d", fmt::format("M{},{}l{},-{}l{},{}z", x, y, size, size, size, size));
  }

  void axes() {
    constexpr std::array<std::pair<double, const char*>, 5> ticks{
        {{-1, "−1"}, {-0.5, "−1/2"}, {0, "0"}, {0.5, "1/2"}, {1, "1"}}};
    for (const auto& [value, written] : ticks) {
      text(place(value, 0).first, bottom + 18, "middle", written);
      if (value > 0) text(left - 8, place(0, value).second + 4, "end", written);
    }
    text((left + right) / 2, bottom + 38, "middle", "u, down the slope");
    text(left - 8, place(0, 1).second - 18, "start", "mu h");
  }

  void mark(const std::pair<int, int>& at, const char* css_class, const std::string& name) {
    svg_.add("circle", css_class).set("cx", at.first).set("cy", at.second).set("r", 4);
    text(at.first + 7, at.second + 4, "start", name).set("font-size", 11);
  }

  const std::vector<Point>& points_;
  const Body& tipping_;
  ElementTree document_{"svg"};
  Element svg_ = document_.root();
};

}  // namespace

std::string map_picture(const std::vector<Point>& points, const Body& tipping) {
  return MapPicture(points, tipping).file();
}

}  // namespace slipproof::test::rest_on_slope
