#include "report/picture/motions_svg.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/number/format.hpp"
#include "report/markup/number.hpp"
#include "report/markup/symbol.hpp"
#include "report/picture/mechanism_svg.hpp"
#include "report/picture/palette.hpp"

namespace slipproof {

namespace {

constexpr double panel_width = 380, panel_height = 330, edge = 14;

class MotionsPicture {
 public:
  MotionsPicture(const Element& svg, const MechanismScene& scene, const MotionsAtLoad& found)
      : svg_(svg),
        scene_(scene),
        count_(found.motions.empty() && found.continua.empty() ? "no motion" : counted_motions(found)),
        motions_(drawn_motions(found)),
        single_(found.motions.size()),
        look_(common_look(scene, motions_)),
        height_(picture_height(scene, panel_height)) {}

  void draw() {
    text({edge, edge + 18}, 18, "ink", scene_.name);
    text({edge, edge + 38}, 14, "soft", below_title());
    for (std::size_t i = 0; i < panels(); ++i) draw(i);
    height_ = std::min(height_, width * (seen_->bottom - seen_->top) / (seen_->right - seen_->left));
    for (std::size_t i = 0; i < panels(); ++i) place(i);
  }

  double whole_width() const {
    const auto across = static_cast<double>(std::min(columns, panels()));
    return 2 * edge + across * width + (across - 1) * between;
  }
  double whole_height() const {
    const auto rows = static_cast<double>((panels() + columns - 1) / columns);
    return edge + title_height + rows * row_height();
  }

 private:
  static constexpr std::size_t columns = 3;
  static constexpr double width = panel_width, between = 16, title_height = 60, heading_height = 28;

  double row_height() const { return heading_height + height_ + between; }
  std::size_t panels() const { return std::max<std::size_t>(motions_.size(), 1); }

  std::string below_title() const {
    std::vector<std::string> parts;
    if (scene_.mechanism.load && scene_.load) {
      const std::string& unit = scene_.mechanism.load->unit;
      parts.push_back(plain_symbol(scene_.mechanism.load->symbol) + " " + look_.numbers->value(*scene_.load) +
                      (unit.empty() || unit == "1" ? "" : " " + unit));
    }
    parts.push_back(count_);
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  const MotionAtLoad* motion(std::size_t i) const { return i < motions_.size() ? &motions_[i] : nullptr; }
  std::string title(std::size_t i) const {
    if (motion(i) == nullptr) return "no motion";
    return fmt::format("{}: {}{}", i + 1, modes_text(*motion(i)), i < single_ ? "" : " (continuum)");
  }

  void draw(std::size_t i) {
    LabelBox seen;
    pictures_.push_back(add_mechanism(svg_, scene_, motion(i), title(i), look_, &seen));
    seen_ = seen_ ? seen_->around(seen) : seen;
  }

  /// All with one viewBox: what does not move is in the same place.
  void place(std::size_t i) const {
    const Point at{edge + static_cast<double>(i % columns) * (width + between),
                   edge + title_height + static_cast<double>(i / columns) * row_height()};
    if (motion(i) != nullptr) text({at[0], at[1] + 16}, 16, "ink", title(i));
    const Element& picture = pictures_[i];
    picture.set("x", at[0]).set("y", at[1] + heading_height).set("width", width).set("height", height_);
    picture.set("viewBox", view_box(*seen_)).set("preserveAspectRatio", "xMidYMin meet");
  }

  void text(Point at, double size, std::string_view css, const std::string& words) const {
    svg_.add("text", css).set("x", at[0]).set("y", at[1]).set("font-size", size).text(words);
  }

  const Element svg_;
  const MechanismScene& scene_;
  const std::string count_;
  const std::vector<MotionAtLoad> motions_;
  const std::size_t single_;  ///< of motions_, those before the continua
  const CommonLook look_;
  double height_;  ///< of a picture
  std::vector<Element> pictures_;
  std::optional<LabelBox> seen_;  ///< of all pictures
};

}  // namespace

std::vector<MotionAtLoad> drawn_motions(const MotionsAtLoad& found) {
  std::vector<MotionAtLoad> all = found.motions;
  for (const ContinuumAtLoad& continuum : found.continua) {
    MotionAtLoad motion;
    (continuum.strict ? motion.modes : motion.boundary_modes).push_back(continuum.mode);
    for (const Range& range : continuum.accelerations) {
      motion.accelerations.push_back(shown_value(range).value_or(Rational(0)));
    }
    motion.forces = continuum.forces;
    all.push_back(std::move(motion));
  }
  return all;
}

CommonLook common_look(const MechanismScene& scene, const std::vector<MotionAtLoad>& motions) {
  std::vector<Range> numbers;
  CommonLook look;
  for (const MotionAtLoad& motion : motions) {
    const std::vector<Range> shown = shown_numbers(scene, &motion);
    numbers.insert(numbers.end(), shown.begin(), shown.end());
    look.largest_force = std::max(look.largest_force, largest_force(scene, motion));
  }
  look.numbers.emplace(numbers);
  look.brief = true;
  return look;
}

std::string motions_svg_file(const MechanismScene& scene, const MotionsAtLoad& found) {
  const ElementTree document("svg");
  const Element svg = document.root().set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
  svg.add("title").text(scene.name);
  svg.add("style").code(picture_style());
  svg.set("font-family", "system-ui, 'DejaVu Sans', sans-serif");
  const Element ground = svg.add("rect", "paper");
  MotionsPicture picture(svg, scene, found);
  picture.draw();
  const double width = picture.whole_width(), height = picture.whole_height();
  ground.set("width", width).set("height", height);
  svg.set("viewBox", fmt::format("0 0 {} {}", short_number(width), short_number(height)));
  svg.set("width", width).set("height", height);
  return document.xml();
}

}  // namespace slipproof
