#include "report/picture/frame/picture_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/input/utf8.hpp"
#include "report/markup/number.hpp"
#include "report/picture/motion_words.hpp"
#include "report/picture/palette.hpp"

namespace slipproof {

namespace {

constexpr double least_width = 360, frame_letter = 0.62, frame_line = 17, frame_margin = 10;

}  // namespace

void PictureFrame::heading(const std::string& name, const std::string& below) {
  const double left = box_.left;
  double y = box_.top - (below.empty() ? 10 : 10 + frame_line);
  for (const auto& [words, usual, css] : {std::tuple{name, 16.0, "ink"}, std::tuple{below, 13.0, "soft"}}) {
    if (words.empty()) continue;
    const double size = std::min(usual, widest / (frame_letter * static_cast<double>(utf8_count(words))));
    svg_.add("text", css).set("x", left).set("y", y).set("font-size", size).text(words);
    see({left, y - size, left + frame_letter * size * static_cast<double>(utf8_count(words)), y});
    y += frame_line + 1;
  }
}

void PictureFrame::caption(const std::vector<std::string>& pieces) {
  const double left = box_.left;
  double y = box_.bottom + frame_line + 2;
  for (const std::string& line : caption_lines(pieces, 54)) {
    svg_.add("text", "soft halo").set("x", left).set("y", y).set("font-size", 12).text(line);
    see({left, y - 12, left + frame_letter * 12 * static_cast<double>(utf8_count(line)), y + 3});
    y += frame_line;
  }
}

LabelBox PictureFrame::box() const {
  const double more = std::max(0.0, share_ * least_width - (box_.right - box_.left)) / 2 + frame_margin;
  return {box_.left - more, box_.top - frame_margin, box_.right + more, box_.bottom + frame_margin};
}

std::string view_box(const LabelBox& box) {
  return fmt::format("{} {} {} {}", short_number(box.left), short_number(box.top), short_number(box.right - box.left),
                     short_number(box.bottom - box.top));
}

std::string picture_file(const std::string& title, double scale,
                         const std::function<DrawnPicture(const Element&)>& draw, const std::string& more_style) {
  const ElementTree document("svg");
  const Element svg = document.root().set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
  svg.add("title").text(title);
  const Element description = svg.add("desc");
  svg.add("style").code(picture_style() + more_style);
  const Element ground = svg.add("rect", "paper");
  svg.set("font-family", "system-ui, 'DejaVu Sans', sans-serif");
  const auto [words, box] = draw(svg);
  description.text(words);
  const double width = box.right - box.left, height = box.bottom - box.top;
  ground.set("x", box.left).set("y", box.top).set("width", width).set("height", height);
  svg.set("viewBox", view_box(box)).set("width", scale * width).set("height", scale * height);
  return document.xml();
}

}  // namespace slipproof
