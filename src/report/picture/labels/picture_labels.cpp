#include "report/picture/labels/picture_labels.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/input/utf8.hpp"
#include "report/markup/symbol.hpp"

namespace slipproof {

namespace {

constexpr double letter_share = 0.62, value_gap = 4, symbol_size = 13, word_size = 12;

double width_of(const std::string& text, double size) {
  return letter_share * size * static_cast<double>(utf8_count(text));
}

/// A symbol, or a product of symbols as `M g`.
bool is_name(const std::string& text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == ' '; }) &&
         std::isalpha(static_cast<unsigned char>(text[0])) != 0;
}

}  // namespace

void PictureLabels::push(const std::vector<Point>& near, const std::string& name, const std::string& value) {
  if (is_name(name)) return symbol(near, name, value);
  symbol(near, {}, name + (value.empty() || value[0] == ' ' ? "" : " ") + value);
}

void PictureLabels::symbol(const std::vector<Point>& near, const std::string& symbol, const std::string& value) {
  double width = width_of(value, symbol_size) + value_gap;
  if (!symbol.empty()) {
    const Symbol set = typeset_symbol(symbol);
    width += width_of(set.letter, symbol_size) + width_of(set.subscript, 0.75 * symbol_size);
  }
  labels_.push_back({near, width, symbol_size + 3});
  texts_.push_back({symbol_size, "ink halo", symbol, value});
}

void PictureLabels::words(const std::vector<Point>& near, const std::string& words) {
  if (words.empty()) return;
  labels_.push_back({near, width_of(words, word_size), word_size + 3});
  texts_.push_back({word_size, "soft halo", {}, words});
}

/// Joins a label that is far from what it names to it.
void PictureLabels::lead(const Element& svg, const LabelBox& box, const std::vector<Point>& near) {
  constexpr double far = 13;
  const auto edge = [&](const Point& p) {
    return Point{std::clamp(p[0], box.left, box.right), std::clamp(p[1], box.top + 3, box.bottom - 3)};
  };
  const auto away = [&](const Point& p) { return std::hypot(edge(p)[0] - p[0], edge(p)[1] - p[1]); };
  const Point to = *std::ranges::min_element(near, {}, away), from = edge(to);
  if (away(to) <= far) return;
  svg.add("line", "measure").set("x1", from[0]).set("y1", from[1]).set("x2", to[0]).set("y2", to[1]);
}

std::vector<LabelBox> PictureLabels::draw(const Element& svg) {
  std::vector<LabelBox> boxes = placer_.place(labels_);
  for (std::size_t i = 0; i < texts_.size(); ++i) lead(svg, boxes[i], labels_[i].near);
  for (std::size_t i = 0; i < texts_.size(); ++i) {
    const Text& label = texts_[i];
    const Element text = svg.add("text", label.css);
    text.set("x", boxes[i].left).set("y", boxes[i].bottom - label.size / 4).set("font-size", label.size);
    if (label.symbol.empty()) {
      text.text(label.words);
      continue;
    }
    svg_symbol(text, label.symbol);
    if (!label.words.empty()) text.add("tspan").set("dx", value_gap).text(label.words);
  }
  return boxes;
}

}  // namespace slipproof
