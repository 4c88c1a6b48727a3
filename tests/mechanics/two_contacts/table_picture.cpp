#include <fmt/format.h>

#include <array>
#include <map>

#include "mechanics/two_contacts/table.hpp"
#include "report/markup/element.hpp"
#include "report/picture/palette.hpp"

namespace slipproof::test::two_contacts {

namespace {

/// Columns that stand together, below two lines of words.
struct Group {
  const char *upper, *lower;
  std::vector<const char*> modes;
};
const std::array<Group, 5> groups{{{"both", "stick", {"SS"}},
                                   {"one sticks,", "one opens", {"SO", "OS"}},
                                   {"both", "slip", {"++", "+-", "-+", "--"}},
                                   {"one slips,", "one opens", {"+O", "-O", "O+", "O-"}},
                                   {"both", "open", {"OO"}}}};

/// A state of one contact: its letters, the class of its colour, and its words in the legend.
struct State {
  std::string letters, css_class;
  const char* words;
  int words_width;
};
const std::array<State, 3> states{{{"S", "fit-stick", "sticks", 42},
                                   {"+-", "fit-slide", "slips (+ forwards, − backwards)", 216},
                                   {"O", "fit-open", "opens", 0}}};

constexpr const char* description =
    "A table of {} sets of modes, ordered by the number of motions; with other names they are {}. Each of the twelve "
    "columns is a contact mode: both contacts stick, one sticks and one opens, both slip, one slips and one opens, "
    "both open. The same table as text is table.txt.";

/// All lengths in pixels, y down.
constexpr int margin = 12, left = 68, right = 46, column = 25, between_groups = 16, row = 15, between_motions = 9;
constexpr int width = left + 12 * column + 4 * between_groups + right;
constexpr int motions_middle = 36, half_mark = 9, mark_height = 10;

std::string rectangle(int x, int y, int wide, int high) {
  return fmt::format("M{},{}h{}v{}h-{}z", x, y, wide, high, wide);
}

/// The middles of the columns.
std::map<std::string, int> middles() {
  std::map<std::string, int> result;
  int x = left + column / 2;
  for (const Group& group : groups) {
    for (const char* mode : group.modes) {
      result[mode] = x;
      x += column;
    }
    x += between_groups;
  }
  return result;
}

class TablePicture {
 public:
  explicit TablePicture(const std::vector<Example>& examples) : rows_(up_to_names(examples, Below::rest)) {}

  std::string file() {
    const Element svg = document_.root().set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
    svg.set("aria-labelledby", "title description").set("font-family", "system-ui, 'DejaVu Sans', sans-serif");
    svg.set("font-size", 13);
    std::size_t sets = 0;
    for (const auto& [modes, count] : rows_) sets += count;
    svg.add("title").set("id", "title").text("Which motions of a body on two contacts occur together");
    svg.add("desc").set("id", "description").text(fmt::format(description, rows_.size(), sets));
    svg.add("style").code(picture_style());
    const Element paper = svg.add("rect", "paper").set("width", width);
    text(svg, margin, 27, "start", "Two contacts: which motions occur together").set("font-size", 17);
    text(svg, margin, 48, "start",
         fmt::format("{} sets of modes; {} with those in which only names differ:", rows_.size(), sets))
        .set("class", "soft");
    text(svg, margin, 65, "start", "+ and − exchanged at a contact, or the contacts exchanged.").set("class", "soft");
    legend(svg, 87);
    heads(svg, 132);
    const int bottom = body(svg, 169);
    line(svg, bottom + 4);
    modes(svg, bottom + 22);
    const int height = bottom + 34;
    paper.set("height", height);
    svg.set("width", width).set("height", height);
    svg.set("viewBox", fmt::format("0 0 {} {}", width, height));
    return document_.xml();
  }

 private:
  static Element text(const Element& svg, int x, int y, const char* anchor, const std::string& words) {
    return svg.add("text", "ink").set("x", x).set("y", y).set("text-anchor", anchor).text(words);
  }

  static void line(const Element& svg, int y) {
    svg.add("path", "frame").set("d", fmt::format("M{},{}H{}", margin, y, width - margin));
  }

  static void legend(const Element& svg, int y) {
    int x = margin;
    for (const State& state : states) {
      svg.add("path", state.css_class).set("d", rectangle(x, y - mark_height, half_mark, mark_height));
      text(svg, x + half_mark + 6, y, "start", state.words);
      x += half_mark + 22 + state.words_width;
    }
    text(svg, margin, y + 19, "start", "Left half of a mark: contact one. Right half: contact two.");
  }

  void heads(const Element& svg, int y) const {
    for (const Group& group : groups) {
      const int x = (middles_.at(group.modes.front()) + middles_.at(group.modes.back())) / 2;
      text(svg, x, y, "middle", group.upper).set("font-size", 12);
      text(svg, x, y + 13, "middle", group.lower).set("font-size", 12);
    }
    modes(svg, y + 32);
  }

  /// The line with the names of the columns.
  void modes(const Element& svg, int y) const {
    text(svg, margin, y, "start", "motions");
    for (const auto& [mode, x] : middles_) {
      std::string name = mode;
      for (std::size_t at; (at = name.find('-')) != name.npos;) name.replace(at, 1, "−");
      text(svg, x, y, "middle", name);
    }
    text(svg, width - margin, y, "end", "sets");
  }

  /// Returns its lower end.
  int body(const Element& svg, int y) const {
    std::map<std::string, std::string> marks;  // by class
    std::string absent;
    std::size_t motions = 0;
    for (const auto& [modes, count] : rows_) {
      if (modes.size() != motions) {
        motions = modes.size();
        line(svg, y + between_motions / 2);
        y += between_motions;
        text(svg, motions_middle, y + 12, "middle", std::to_string(motions)).set("font-weight", "bold");
      }
      for (const auto& [mode, x] : middles_) {
        if (!modes.contains(mode)) {
          absent += rectangle(x - 1, y + 7, 2, 2);
          continue;
        }
        for (const State& state : states) {
          for (const int side : {0, 1}) {
            if (state.letters.find(mode[static_cast<std::size_t>(side)]) == std::string::npos) continue;
            marks[state.css_class] += rectangle(x + (side - 1) * half_mark, y + 3, half_mark, mark_height);
          }
        }
      }
      text(svg, width - margin - 6, y + 12, "end", std::to_string(count));
      y += row;
    }
    svg.add("path", "fit-open").set("opacity", "0.6").set("d", absent);
    for (const auto& [css_class, path] : marks) svg.add("path", css_class).set("d", path);
    return y;
  }

  std::vector<std::pair<Modes, std::size_t>> rows_;
  std::map<std::string, int> middles_ = middles();
  ElementTree document_{"svg"};
};

}  // namespace

std::string table_picture(const std::vector<Example>& examples) {
  return TablePicture(examples).file();
}

}  // namespace slipproof::test::two_contacts
