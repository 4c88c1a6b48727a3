// Pictures of mechanisms as tests read them: arrows, texts and whether all can be read.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cctype>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "base/input/utf8.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/picture/mechanism_svg.hpp"

namespace slipproof::test {

inline const std::string drawn_scenes = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/scenes/";

struct DrawnMechanism {
  pugi::xml_document tree;
  std::array<double, 4> view{};
};

inline DrawnMechanism read_picture(const std::string& svg) {
  DrawnMechanism result;
  REQUIRE(result.tree.load_string(svg.c_str(), pugi::parse_default | pugi::parse_ws_pcdata));
  std::istringstream view(result.tree.document_element().attribute("viewBox").value());
  for (double& x : result.view) view >> x;
  return result;
}

inline DrawnMechanism drawn(const MechanismScene& scene, const MotionAtLoad* motion = nullptr) {
  return read_picture(mechanism_svg_file(scene, motion));
}

inline MotionsAtLoad motions(const MechanismScene& scene) {
  return motions_of(friction_problem(scene.mechanism, scene.values), scene.load);
}

inline std::string all_text(const pugi::xml_node& node) {
  std::string text;
  for (const auto& found : node.select_nodes(".//text()")) text += found.node().value();
  return text;
}

/// The numbers of a path.
inline std::vector<double> numbers(std::string path) {
  for (char& c : path) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0 || c == ',') c = ' ';
  }
  std::istringstream in(path);
  std::vector<double> all;
  for (double x = 0; in >> x;) all.push_back(x);
  return all;
}

struct DrawnArrow {
  double from_x, from_y, dx, dy;
  bool dashed;
  double length() const { return std::hypot(dx, dy); }
};

inline std::vector<DrawnArrow> arrows(const DrawnMechanism& picture, const std::string& css) {
  std::vector<DrawnArrow> all;
  for (const auto& found : picture.tree.select_nodes(("//g[@class='" + css + "']").c_str())) {
    const auto line = found.node().child("line");
    const auto tip = numbers(found.node().child("path").attribute("d").value());
    const double x = line.attribute("x1").as_double(), y = line.attribute("y1").as_double();
    all.push_back({x, y, tip[0] - x, tip[1] - y, !line.attribute("stroke-dasharray").empty()});
  }
  return all;
}

struct TextBox {
  double left, top, right, bottom;
  std::string words;
};

/// As narrow fonts have it: letters half as wide as the font is high.
inline std::vector<TextBox> text_boxes(const DrawnMechanism& picture) {
  std::vector<TextBox> boxes;
  for (const auto& found : picture.tree.select_nodes("//text")) {
    const auto text = found.node();
    const std::string words = all_text(text);
    const double x = text.attribute("x").as_double(), y = text.attribute("y").as_double();
    const double size = text.attribute("font-size").as_double();
    boxes.push_back({x, y - 0.75 * size, x + 0.5 * size * static_cast<double>(utf8_count(words)), y, words});
  }
  return boxes;
}

inline void check_readable(const DrawnMechanism& picture) {
  const double left = picture.view[0], top = picture.view[1], right = left + picture.view[2],
               bottom = top + picture.view[3];
  CHECK(picture.view[2] < 520);  // letters of 12 are at least 8 pixels high in 400
  const auto boxes = text_boxes(picture);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    CAPTURE(boxes[i].words);
    CHECK((boxes[i].left >= left && boxes[i].right <= right && boxes[i].top >= top && boxes[i].bottom <= bottom));
    for (std::size_t j = 0; j < i; ++j) {
      CAPTURE(boxes[j].words);
      CHECK((boxes[i].right <= boxes[j].left || boxes[j].right <= boxes[i].left || boxes[i].bottom <= boxes[j].top ||
             boxes[j].bottom <= boxes[i].top));
    }
  }
  for (const auto& found : picture.tree.select_nodes("//path")) {
    const auto all = numbers(found.node().attribute("d").value());
    for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
      CHECK((all[i] >= left && all[i] <= right && all[i + 1] >= top && all[i + 1] <= bottom));
    }
  }
  for (const auto& found : picture.tree.select_nodes("//circle")) {
    const auto c = found.node();
    const double x = c.attribute("cx").as_double(), y = c.attribute("cy").as_double(), r = c.attribute("r").as_double();
    CHECK((x - r >= left && x + r <= right && y - r >= top && y + r <= bottom));
  }
}

}  // namespace slipproof::test
