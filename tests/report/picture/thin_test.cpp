// What is in the columns of a diagram is in its picture and its legend, however thin.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <pugixml.hpp>
#include <sstream>

#include "base/number/binary64.hpp"
#include "mechanics/planes/mechanism_plane.hpp"
#include "report/phase/phase_svg.hpp"
#include "report/phase/thin_regions.hpp"

using namespace slipproof;

namespace {

const std::filesystem::path cases = SLIPPROOF_SOURCE_DIR "/cases";

std::vector<MechanismScene> shipped_bicycles() {
  std::vector<MechanismScene> scenes;
  for (const auto& folder : {cases, cases / "short-and-tall"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".toml") scenes.push_back(read_scene(entry.path()));
    }
  }
  return scenes;
}

using Point = std::array<double, 2>;
using Polygon = std::vector<Point>;

std::vector<Polygon> polygons(const std::string& path) {
  std::vector<Polygon> all;
  std::string numbers = path;
  for (char& c : numbers) {
    if (c == 'L' || c == ',') c = ' ';
  }
  std::istringstream parts(numbers);
  for (std::string part; std::getline(parts, part, 'Z');) {
    std::istringstream in(part.substr(part.find('M') + 1));
    all.emplace_back();
    for (Point p{}; in >> p[0] >> p[1];) all.back().push_back(p);
  }
  return all;
}

/// By Sutherland and Hodgman: what is left of a polygon on one side of an upright or level line.
Polygon cut(const Polygon& polygon, std::size_t axis, double at, double side) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = side * (a[axis] - at), to = side * (b[axis] - at);
    if (from >= 0) result.push_back(a);
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
      const double t = from / (from - to);
      result.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
    }
  }
  return result;
}

/// Its area over its length, about: of a triangle, half of its width.
double mean_width(const Polygon& polygon) {
  double area = 0;
  Point low{1e9, 1e9}, high{-1e9, -1e9};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
    for (std::size_t k : {0U, 1U}) low[k] = std::min(low[k], a[k]), high[k] = std::max(high[k], a[k]);
  }
  const double length = std::hypot(high[0] - low[0], high[1] - low[1]);
  return length > 0 ? std::abs(area) / length : 0;
}

/// The widest part inside of the plot that is filled for a set of motions.
double drawn_width(const pugi::xml_node& picture, const std::string& set) {
  double left = 0, top = 0, width = 0, height = 0, widest = 0;
  std::istringstream(picture.attribute("data-plot").value()) >> left >> top >> width >> height;
  for (const auto& found : picture.select_nodes(".//path[title]")) {
    const std::string title = found.node().child_value("title");
    if (title != set && title != set + ", drawn wider than it is") continue;
    for (Polygon part : polygons(found.node().attribute("d").value())) {
      part = cut(cut(part, 0, left, 1), 0, left + width, -1);
      part = cut(cut(part, 1, top, 1), 1, top + height, -1);
      widest = std::max(widest, mean_width(part));
    }
  }
  return widest;
}

}  // namespace

TEST_CASE(
    "every set of motions in the range of every shipped bicycle is in the picture, as wide as can be seen, and in the "
    "legend") {
  int thin = 0;
  for (const MechanismScene& scene : shipped_bicycles()) {
    CAPTURE(scene.name);
    const PhaseDiagram diagram = phase_diagram(mechanism_plane(scene, {}, "s"), 48);
    pugi::xml_document document;
    REQUIRE(document.load_string(phase_svg_file(diagram).c_str()));
    const pugi::xml_node picture = document.select_node("//svg[@data-plot]").node();
    std::vector<MotionSet> sets;
    for (const PhaseColumn& column : diagram.columns) {
      for (const LoadCell* cell : open_cells(column)) {
        ForceInterval seen = ForceInterval::between(diagram.plane.y.from, false, diagram.plane.y.to, false);
        seen.intersect(cell->loads);
        if (seen.empty()) continue;  // beyond the picture
        if (std::find(sets.begin(), sets.end(), motion_set(*cell)) == sets.end()) sets.push_back(motion_set(*cell));
      }
    }
    for (const MotionSet& set : sets) {
      const std::string words = name(set);
      CAPTURE(words);
      CHECK(drawn_width(picture, words) > 1);
      const auto names_it = [&](const auto& found) {
        return std::string(found.node().child_value("text")).find(words.substr(0, 60)) != std::string::npos;
      };
      const auto keys = document.select_nodes("//g[@class='key']");
      CHECK(std::any_of(keys.begin(), keys.end(), names_it));
    }
    thin += static_cast<int>(document.select_nodes("//circle[@class='new ring']").size());
  }
  CHECK(thin > 10);
}

TEST_CASE("the three motions of the ambiguous bicycle are enlarged until they can be seen") {
  const MechanismScene scene = read_scene(cases / "ambiguous.toml");
  const PhaseDiagram diagram = phase_diagram(mechanism_plane(scene, {}, "s"), 60);
  const PhasePicture picture = phase_picture(diagram);
  const auto three = std::find_if(picture.regions.sets.begin(), picture.regions.sets.end(),
                                  [](const MotionSet& set) { return set.motions.size() == 3; });
  REQUIRE(three != picture.regions.sets.end());
  const auto index = static_cast<std::size_t>(three - picture.regions.sets.begin());
  const auto& thin = picture.thin.regions;
  const auto region = std::find_if(thin.begin(), thin.end(), [&](const ThinRegion& r) { return r.set == index; });
  REQUIRE(region != thin.end());
  REQUIRE(region->enlargement);
  CHECK(thin_note(picture, index).find("drawn wider") != std::string::npos);
  const Enlargement& enlarged = picture.thin.enlargements[*region->enlargement];
  const Axis &x = enlarged.diagram.plane.x, &y = enlarged.diagram.plane.y;
  CHECK(thickness(enlarged.regions, *three, Frame(0, 0, 300, 200, x, y)).value_or(0) > least_seen);
  CHECK(x.from < to_rational(region->at.x));
  CHECK(to_rational(region->at.x) <= x.to);
}
