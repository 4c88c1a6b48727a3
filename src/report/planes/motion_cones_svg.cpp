#include <fmt/format.h>

#include "base/number/format.hpp"
#include "report/markup/number.hpp"
#include "report/planes/cone_signs.hpp"
#include "report/planes/motion_cones.hpp"

namespace slipproof {

namespace {

// The picture is drawn in its own size, so that its words are as large as those around it. Twelve contacts fit the
// page.
constexpr double head_width = 132, head_height = 26, page_width = 984, line_height = 16;
constexpr std::size_t line_letters = 17;

/// The words in front of a row, one line each: its number and mode, broken between contacts, and what it is beyond.
std::vector<std::string> head_lines(const MotionRow& row, std::size_t number, std::size_t columns) {
  std::vector<std::string> lines{std::to_string(number) + ":"};
  std::size_t begin = 0;
  for (std::size_t k = 0; k < columns && begin < row.mode.size(); ++k) {
    const std::size_t end = std::min(row.mode.find('/', begin), row.mode.size() - 1) + 1;
    const std::string state = row.mode.substr(begin, end - begin);
    if (k == 0) {
      lines.back() += " " + state;
    } else if (lines.back().size() + state.size() > line_letters) {
      lines.push_back(state);
    } else {
      lines.back() += state;
    }
    begin = end;
  }
  if (begin < row.mode.size()) lines.back() += "…";
  return lines;
}

std::vector<std::string> notes_of(const MotionRow& row) {
  std::vector<std::string> notes;
  if (!row.kind.empty()) notes.emplace_back(row.kind);
  if (row.nearest) notes.emplace_back("nearest");
  return notes;
}

void add_contact_motion(const Element& svg, const ContactMotion& motion, Point center, double unit) {
  const Element group = svg.add("g", motion.lifts ? "contact lifts" : "contact");
  group.set("data-plot", fmt::format("{:.2f} {:.2f} {:.2f}", center[0], center[1], unit));
  if (motion.lifts) return add_boundary(group, center, unit, FrictionLaw::cone, "line");
  add_cone_axes(group, center, unit);
  add_boundary(group, center, unit, FrictionLaw::cone, "edge");
  if (motion.slip) {
    constexpr double beyond = 1.25;
    const Point tip = in_disc(center, beyond * unit, *motion.slip);
    add_arrow(group, center, tip[0] - center[0], tip[1] - center[1], "moves");
  }
  if (!motion.force) return;
  const Element points = group.add("g", fill_class(motion.slip ? ConeSign::slide : ConeSign::stick));
  add_cone_point(points, in_disc(center, unit, *motion.force), 5, motion.slip.has_value());
}

std::string contact_motion_words(const ContactMotion& motion) {
  std::string text(state_of(motion));
  if (motion.slip) text += fmt::format(" at {:.0f} degrees", degrees_of(*motion.slip));
  if (motion.force) text += fmt::format(", force at ({:.4g}, {:.4g})", (*motion.force)[0], (*motion.force)[1]);
  return text;
}

/// A description for readers who do not see the picture.
std::string words_for_motions(const MotionCones& cones) {
  std::string text = counted(cones.motions, "motion") + " of " + counted(cones.contacts, "contact") + ".";
  for (std::size_t i = 0; i < cones.rows.size(); ++i) {
    text += fmt::format(" {}, {}:", i + 1, cones.rows[i].mode);
    const auto& contacts = cones.rows[i].contacts;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      text += fmt::format("{} contact {} {}", k == 0 ? "" : ";", k + 1, contact_motion_words(contacts[k]));
    }
    text += ".";
  }
  return text;
}

class MotionGrid {
 public:
  explicit MotionGrid(const MotionCones& cones) : cones_(cones) {
    cell_ = std::clamp((page_width - head_width) / static_cast<double>(cones.columns()), 71.0, 92.0);
    for (std::size_t i = 0; i < cones.rows.size(); ++i) {
      heads_.push_back(head_lines(cones.rows[i], i + 1, cones.columns()));
      notes_.push_back(notes_of(cones.rows[i]));
    }
  }

  double width() const { return head_width + cell_ * static_cast<double>(cones_.columns()); }
  double height() const {
    double sum = head_height;
    for (std::size_t i = 0; i < heads_.size(); ++i) sum += row_height(i);
    return sum;
  }

  void draw(const Element& svg) const {
    for (std::size_t k = 0; k < cones_.columns(); ++k) {
      const Element name = svg.add("text", "soft").set("x", column(k)).set("y", 15);
      name.set("text-anchor", "middle").text("contact " + std::to_string(k + 1));
    }
    double top = head_height;
    for (std::size_t i = 0; i < heads_.size(); ++i) {
      draw_row(svg.add("g", "motion-row"), i, top);
      top += row_height(i);
    }
  }

 private:
  double column(std::size_t contact) const { return head_width + (static_cast<double>(contact) + 0.5) * cell_; }
  double lines_height(std::size_t row) const {
    return line_height * static_cast<double>(heads_[row].size() + notes_[row].size());
  }
  double row_height(std::size_t row) const { return std::max(cell_, lines_height(row) + line_height); }

  void draw_row(const Element& group, std::size_t row, double top) const {
    add_path(group, "measure", fmt::format("M0,{:.2f}h{:.2f}", top, width()));
    const double center = top + row_height(row) / 2;
    double line = center - lines_height(row) / 2 + 12;
    const auto write = [&](const std::string& words, const char* css_class) {
      group.add("text", css_class).set("x", 2).set("y", line).text(words);
      line += line_height;
    };
    for (const std::string& words : heads_[row]) write(words, "ink");
    for (const std::string& words : notes_[row]) write(words, "soft");
    const auto& contacts = cones_.rows[row].contacts;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      add_contact_motion(group, contacts[k], {column(k), center}, 0.34 * cell_);
    }
  }

  const MotionCones& cones_;
  double cell_ = 0;
  std::vector<std::vector<std::string>> heads_, notes_;
};

}  // namespace

Element add_motion_cones(const Element& parent, const MotionCones& cones, const std::string& id) {
  const MotionGrid grid(cones);
  const Element svg = parent.add("svg", "motion-cones").set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
  svg.set("viewBox", fmt::format("0 0 {} {}", short_number(grid.width()), short_number(grid.height())));
  svg.set("style", "width:" + short_number(grid.width()) + "px").set("font-size", 12);
  svg.set("aria-labelledby", id + "-title " + id + "-text");
  svg.add("title").set("id", id + "-title").text("All motions, contact by contact");
  svg.add("desc").set("id", id + "-text").text(words_for_motions(cones));
  grid.draw(svg);
  return svg;
}

}  // namespace slipproof
