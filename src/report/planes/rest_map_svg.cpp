#include "report/planes/rest_map_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "report/markup/number.hpp"
#include "report/phase/axis.hpp"
#include "report/picture/palette.hpp"
#include "report/scenes/rest_words.hpp"

namespace slipproof {

namespace {

constexpr double map_width = 760, plot_left = 84, plot_top = 52, plot_side = 460, legend_line = 22;
constexpr std::size_t most_numbered = 12;
constexpr int map_digits = 4;

std::string unit_of(const Mechanism& mechanism, const std::string& symbol) {
  if (mechanism.load && mechanism.load->symbol == symbol) return mechanism.load->unit;
  const auto found = std::ranges::find(mechanism.parameters, symbol, &MechanismParameter::symbol);
  return found == mechanism.parameters.end() ? std::string() : found->unit;
}

class RestMapPicture {
 public:
  explicit RestMapPicture(const RestAnswer& answer)
      : answer_(answer),
        map_(*answer.map),
        frame_(plot_left, plot_top, map_width - plot_left - 40, plot_side, axis(0), axis(1)) {}

  std::string file() {
    const ElementTree document("svg");
    const Element svg = document.root().set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
    svg.set("width", map_width).set("font-family", "system-ui, 'DejaVu Sans', sans-serif").set("font-size", 12);
    const std::string title = answer_.scene.name + ": where it can rest";
    svg.add("title").text(title);
    svg.add("style").code(picture_style());
    const Element paper = svg.add("rect", "paper").set("width", map_width);
    svg.add("text", "ink").set("x", plot_left).set("y", 26).set("font-size", 16).text(title);
    draw_regions(svg);
    draw_borders(svg);
    frame_.draw(svg);
    draw_scene(svg);
    const double height = draw_legend(svg, plot_top + plot_side + 74);
    paper.set("height", height);
    svg.set("height", height).set("viewBox", fmt::format("0 0 {} {}", short_number(map_width), short_number(height)));
    return document.xml();
  }

 private:
  /// As wide as what is drawn, and a twelfth more on both sides.
  Axis axis(std::size_t k) const {
    std::vector<Rational> seen;
    for (const auto& corner : map_.around) seen.push_back(corner[k]);
    for (const RestMap::Corner& corner : map_.inside) seen.push_back(k == 0 ? corner.x : corner.y);
    const auto& here = k == 0 ? map_.x_here : map_.y_here;
    if (here) seen.push_back(*here);
    if (seen.empty()) seen.emplace_back(0);
    const auto [least, most] = std::ranges::minmax(seen);
    Rational margin = (most - least) / 12;
    if (margin.is_zero()) margin = least.is_zero() ? Rational(1) : abs(least);
    const std::string& symbol = k == 0 ? map_.x : map_.y;
    return {symbol, least - margin, most + margin, unit_of(answer_.scene.mechanism, symbol), false};
  }

  Pixel pixel(const Rational& x, const Rational& y) const {
    return {frame_.x_of(nearest_binary64(x)), frame_.y_of(nearest_binary64(y))};
  }

  void draw_regions(const Element& svg) const {
    std::vector<Pixel> around, inside;
    for (const auto& corner : map_.around) around.push_back(pixel(corner[0], corner[1]));
    for (const RestMap::Corner& corner : map_.inside) inside.push_back(pixel(corner.x, corner.y));
    if (!map_.exact && around.size() > 1) svg.add("path", "m15").set("d", closed_path_of(around));
    if (inside.size() > 1) svg.add("path", "m0").set("d", closed_path_of(inside));
    if (inside.size() == 2) svg.add("path", "edge").set("d", path_of(inside));
    for (const Pixel& p : inside) svg.add("circle", "dot").set("cx", p.x).set("cy", p.y).set("r", 3);
  }

  bool numbered() const { return map_.borders.size() <= most_numbered; }

  /// The edge of `around` on each border; its number stands outside of its middle.
  void draw_borders(const Element& svg) const {
    for (std::size_t i = 0; i < map_.borders.size(); ++i) {
      const RestMap::Border& border = map_.borders[i];
      std::vector<Pixel> on;
      for (const auto& corner : map_.around) {
        if (border.x * corner[0] + border.y * corner[1] == border.most) on.push_back(pixel(corner[0], corner[1]));
      }
      if (on.size() > 1) svg.add("path", "edge").set("d", path_of(on));
      if (on.empty() || !numbered()) continue;
      // The normal in the picture: what is equal along the border stays equal.
      const double nx = nearest_binary64(border.x) / (frame_.x_of(1) - frame_.x_of(0));
      const double ny = nearest_binary64(border.y) / (frame_.y_of(1) - frame_.y_of(0));
      const double length = std::hypot(nx, ny);
      if (!(length > 0)) continue;
      const double x = (on.front().x + on.back().x) / 2 + 13 * nx / length;
      const double y = (on.front().y + on.back().y) / 2 + 13 * ny / length;
      svg.add("text", "ink halo").set("x", x).set("y", y + 4).set("text-anchor", "middle").text(std::to_string(i + 1));
    }
  }

  void draw_scene(const Element& svg) const {
    if (!map_.x_here || !map_.y_here) return;
    const Pixel p = pixel(*map_.x_here, *map_.y_here);
    svg.add("circle", "highlight").set("cx", p.x).set("cy", p.y).set("r", 5);
    svg.add("text", "ink halo").set("x", p.x + 9).set("y", p.y - 7).text("the scene");
  }

  double draw_legend(const Element& svg, double top) const {
    double y = top;
    const auto entry = [&](std::string_view css, const std::string& words) {
      svg.add("rect", std::string(css) + " outline")
          .set("x", plot_left)
          .set("y", y - 12)
          .set("width", 28)
          .set("height", 16);
      svg.add("text", "ink").set("x", plot_left + 38).set("y", y).text(words);
      y += legend_line;
    };
    if (map_.none) {
      entry("paper", "it rests nowhere");
    } else {
      entry("m0", "it can rest: forces hold it at the dots, so in all between");
      if (!map_.exact) entry("m15", fmt::format("open, at most {:.2g} of the width and height", map_.gap));
      entry("paper", "it cannot rest: beyond each border a virtual motion gains power");
    }
    for (std::size_t i = 0; numbered() && i < map_.borders.size(); ++i) {
      const std::string words = contact_words(answer_.problem, map_.borders[i].motion);
      std::string line = fmt::format("{}: {}", i + 1, border_text(map_, map_.borders[i], map_digits));
      if (!words.empty()) line += "; " + words;
      constexpr std::size_t most = 100;
      if (line.size() > most) line = line.substr(0, most - 3) + "…";
      svg.add("text", "soft").set("x", plot_left).set("y", y).text(line);
      y += legend_line;
    }
    if (map_.x_frame.from || map_.x_frame.to || map_.y_frame.from || map_.y_frame.to) {
      svg.add("text", "soft").set("x", plot_left).set("y", y).text("an edge without a number: more was not asked for");
      y += legend_line;
    }
    return y;
  }

  const RestAnswer& answer_;
  const RestMap& map_;
  const Frame frame_;
};

}  // namespace

std::string rest_map_svg_file(const RestAnswer& answer) {
  return RestMapPicture(answer).file();
}

}  // namespace slipproof
