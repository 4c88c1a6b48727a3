#include "report/picture/frame/panels.hpp"

#include <algorithm>
#include <optional>

#include "base/input/utf8.hpp"

namespace slipproof {

namespace {

constexpr std::size_t panel_columns = 3;
constexpr double panel_width = 380, panel_edge = 14, between_panels = 16, sheet_title_height = 60;

class PanelGrid {
 public:
  PanelGrid(const Element& svg, const PanelSheet& sheet) : svg_(svg), sheet_(sheet), height_(sheet.height) {}

  DrawnPicture draw() {
    text({panel_edge, panel_edge + 18}, 18, "ink", sheet_.title, inner_width());
    text({panel_edge, panel_edge + 38}, 14, "soft", sheet_.below, inner_width());
    std::optional<LabelBox> seen;
    std::vector<Element> pictures;
    for (const Panel& panel : sheet_.panels) {
      LabelBox box;
      pictures.push_back(panel.draw(svg_, box));
      seen = seen ? seen->around(box) : box;
    }
    height_ = std::min(height_, panel_width * (seen->bottom - seen->top) / (seen->right - seen->left));
    for (std::size_t i = 0; i < pictures.size(); ++i) place(i, pictures[i], *seen);
    const double width = 2 * panel_edge + inner_width();
    const auto rows = static_cast<double>((pictures.size() + panel_columns - 1) / panel_columns);
    double height = panel_edge + sheet_title_height + rows * row_height();
    if (sheet_.legend) height += sheet_.legend(svg_, {panel_edge, height}, inner_width()) + panel_edge;
    return {sheet_.below, {0, 0, width, height}};
  }

 private:
  double inner_width() const {
    const auto across = static_cast<double>(std::min(panel_columns, sheet_.panels.size()));
    return across * panel_width + (across - 1) * between_panels;
  }
  double heading_height() const {
    const bool two = std::ranges::any_of(sheet_.panels, [](const Panel& panel) { return !panel.below.empty(); });
    return two ? 46 : 28;
  }
  double row_height() const { return heading_height() + height_ + between_panels; }

  void place(std::size_t i, const Element& picture, const LabelBox& seen) const {
    const Point at{panel_edge + static_cast<double>(i % panel_columns) * (panel_width + between_panels),
                   panel_edge + sheet_title_height + static_cast<double>(i / panel_columns) * row_height()};
    text({at[0], at[1] + 16}, 16, "ink", sheet_.panels[i].heading, panel_width);
    text({at[0], at[1] + 34}, 13, "soft", sheet_.panels[i].below, panel_width);
    picture.set("x", at[0]).set("y", at[1] + heading_height()).set("width", panel_width).set("height", height_);
    picture.set("viewBox", view_box(seen)).set("preserveAspectRatio", "xMidYMin meet");
  }

  void text(Point at, double usual, std::string_view css, const std::string& words, double width) const {
    if (words.empty()) return;
    const double size = std::min(usual, width / (0.62 * static_cast<double>(utf8_count(words))));
    svg_.add("text", css).set("x", at[0]).set("y", at[1]).set("font-size", size).text(words);
  }

  const Element svg_;
  const PanelSheet& sheet_;
  double height_;  ///< of a picture
};

}  // namespace

std::string panels_svg_file(const PanelSheet& sheet) {
  return picture_file(
      sheet.title, 1, [&](const Element& svg) { return PanelGrid(svg, sheet).draw(); }, sheet.more_style);
}

}  // namespace slipproof
