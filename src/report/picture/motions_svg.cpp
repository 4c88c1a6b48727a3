#include "report/picture/motions_svg.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "base/number/format.hpp"
#include "mechanics/scene/bicycle_scene.hpp"
#include "report/markup/number.hpp"
#include "report/markup/symbol.hpp"
#include "report/picture/bicycle_svg.hpp"
#include "report/picture/drawing.hpp"
#include "report/picture/mechanism_svg.hpp"
#include "report/picture/palette.hpp"

namespace slipproof {

namespace {

constexpr double panel_width = 380, panel_height = 330, edge = 14;

void add_text(const Element& svg, Point at, double size, std::string_view css, const std::string& words) {
  svg.add("text", css).set("x", at[0]).set("y", at[1]).set("font-size", size).text(words);
}

/// Where every contact is in one state, that state; a bicycle's picture does not name its contacts.
std::string in_words(const MechanismScene& scene, const MotionAtLoad& motion) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < scene.mechanism.contacts.size(); ++i) words.push_back(contact_text(scene, &motion, i));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// The root of a file, on which the size is set once it is known.
struct PictureFile {
  ElementTree document{"svg"};
  Element svg, ground;

  explicit PictureFile(const std::string& title) : svg(document.root()), ground(begin(svg, title)) {}

  static Element begin(const Element& svg, const std::string& title) {
    svg.set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
    svg.add("title").text(title);
    svg.add("style").code(picture_style());
    svg.set("font-family", "system-ui, 'DejaVu Sans', sans-serif");
    return svg.add("rect", "paper");
  }
  std::string xml(double across, double down) const {
    ground.set("width", across).set("height", down);
    svg.set("viewBox", fmt::format("0 0 {} {}", short_number(across), short_number(down)));
    svg.set("width", across).set("height", down);
    return document.xml();
  }
};

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
    for (std::size_t i = 0; i < panels(); ++i) panel(i);
  }

  double whole_width() const {
    const auto across = static_cast<double>(std::min(columns, panels()));
    return 2 * edge + across * width + (across - 1) * between;
  }
  double whole_height() const {
    const auto rows = static_cast<double>((panels() + columns - 1) / columns);
    return edge + title_height + rows * (heading_height + height_);
  }

 private:
  static constexpr std::size_t columns = 3;
  static constexpr double width = panel_width, between = 16, title_height = 60, heading_height = 46;

  bool bicycle() const { return is_bicycle(scene_.mechanism); }
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

  void panel(std::size_t i) {
    const Point at{edge + static_cast<double>(i % columns) * (width + between),
                   edge + title_height + static_cast<double>(i / columns) * (heading_height + height_)};
    const MotionAtLoad* motion = i < motions_.size() ? &motions_[i] : nullptr;
    std::string title = "no motion";
    if (motion != nullptr) {
      title = fmt::format("{}: {}{}", i + 1, modes_text(*motion), i < single_ ? "" : " (continuum)");
      text({at[0], at[1] + 16}, 16, "ink", title);
      if (bicycle()) text({at[0], at[1] + 36}, 13, "soft", in_words(scene_, *motion));
    }
    const Element picture = add_motion(svg_, scene_, motion, title, look_);
    picture.set("x", at[0]).set("y", at[1] + heading_height).set("width", width).set("height", height_ - between);
    picture.set("preserveAspectRatio", "xMidYMin meet");
  }

  void text(Point at, double size, std::string_view css, const std::string& words) const {
    add_text(svg_, at, size, css, words);
  }

  const Element svg_;
  const MechanismScene& scene_;
  const std::string count_;
  const std::vector<MotionAtLoad> motions_;
  const std::size_t single_;  ///< of motions_, those before the continua
  const CommonLook look_;
  const double height_;
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
  const bool bicycle = is_bicycle(scene.mechanism);
  std::vector<Range> numbers;
  CommonLook look;
  for (const MotionAtLoad& motion : motions) {
    const std::vector<Range> shown = bicycle ? bicycle_numbers(scene, &motion) : shown_numbers(scene, &motion);
    numbers.insert(numbers.end(), shown.begin(), shown.end());
    if (!bicycle) look.largest_force = std::max(look.largest_force, largest_force(scene, motion));
  }
  look.numbers.emplace(numbers);
  look.brief = true;
  return look;
}

Element add_motion(const Element& parent, const MechanismScene& scene, const MotionAtLoad* motion,
                   std::string_view title, const CommonLook& look) {
  return is_bicycle(scene.mechanism) ? add_bicycle(parent, scene, motion, title, look.numbers)
                                     : add_mechanism(parent, scene, motion, title, look);
}

std::string motion_svg_file(const MechanismScene& scene, const MotionAtLoad& motion) {
  if (!is_bicycle(scene.mechanism)) return mechanism_svg_file(scene, &motion);
  constexpr double scale = 1.6, heading = 88;
  const std::string modes = modes_text(motion);
  const PictureFile file(scene.name + ": " + modes);
  add_text(file.svg, {edge, 30}, 22, "ink", scene.name);
  add_text(file.svg, {edge, 54}, 18, "soft", modes);
  add_text(file.svg, {edge, 78}, 18, "soft", in_words(scene, motion));
  add_bicycle(file.svg, scene, &motion, modes)
      .set("x", edge)
      .set("y", heading)
      .set("width", scale * panel_width)
      .set("height", scale * (panel_height - edge));
  return file.xml(scale * panel_width + 2 * edge, heading + scale * (panel_height - edge) + edge);
}

std::string motions_svg_file(const MechanismScene& scene, const MotionsAtLoad& found) {
  const PictureFile file(scene.name);
  MotionsPicture picture(file.svg, scene, found);
  picture.draw();
  return file.xml(picture.whole_width(), picture.whole_height());
}

}  // namespace slipproof
