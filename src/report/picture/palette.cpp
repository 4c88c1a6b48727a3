#include "report/picture/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace slipproof {

namespace {

struct Colour {
  std::string_view light, dark;
};

/// For two contacts: stick, slip+, slip-, lift of the first one; within each, the same states of the second one.
constexpr std::array<Colour, 16> mode_colours{{{"#a6cbea", "#2b5a86"},
                                               {"#8fd3b3", "#1f6b50"},
                                               {"#bfe6e4", "#2a6f74"},
                                               {"#cdbfe8", "#564692"},
                                               {"#dfe08c", "#6b6a1b"},
                                               {"#c3d69b", "#4d662b"},
                                               {"#e3d0a6", "#705b2c"},
                                               {"#b9c0f0", "#434b9a"},
                                               {"#f9d989", "#8d680c"},
                                               {"#ee9f78", "#96431b"},
                                               {"#e9bfb2", "#804c3c"},
                                               {"#e5a3c5", "#8a3b6b"},
                                               {"#a4b3d8", "#3c4f82"},
                                               {"#a3cfd2", "#33656a"},
                                               {"#dab3dc", "#703e74"},
                                               {"#c8c8c8", "#5c5c5c"}}};

struct Ink {
  std::string_view light, dark, rule;
};

/// The colours of everything else.
constexpr std::array<Ink, 27> inks{{{"#1d2733", "#e8edf3", ".ink{{fill:{}}}"},
                                    {"#55606e", "#a9b4c1", ".soft{{fill:{}}}"},
                                    {"#1d2733", "#e8edf3", ".edge{{fill:none;stroke-width:1.6;stroke:{}}}"},
                                    {"#b3125f", "#ff8fc0", ".new{{fill:none;stroke-width:2.4;stroke:{}}}"},
                                    {"#4c5866", "#b9c4d0", ".curve{{fill:none;stroke-dasharray:2 4;stroke:{}}}"},
                                    {"#4c5866", "#b9c4d0", ".line{{fill:none;stroke-dasharray:7 4;stroke:{}}}"},
                                    {"#b3125f", "#ff8fc0", ".misprint{{fill:none;stroke-dasharray:7 4;stroke:{}}}"},
                                    {"#8b95a1", "#7d8896", ".frame{{fill:none;stroke:{}}}"},
                                    {"#8b95a1", "#7d8896", ".outline{{stroke:{}}}"},
                                    {"#ffffff", "#14191f", ".paper{{fill:{}}}"},
                                    {"#ffffff", "#14191f", ".halo{{paint-order:stroke;stroke-width:3.5;stroke:{}}}"},
                                    {"#4d3a80", "#d9ccff", ".dots{{fill:{}}}"},
                                    {"#b3125f", "#ff8fc0", ".hatching{{fill:none;stroke-width:1.4;stroke:{}}}"},
                                    {"#0b5fa5", "#7cc0ff", ".dot{{fill:{}}}"},
                                    {"#17663f", "#8fdcb0", ".highlight{{fill:{}}}"},
                                    {"#1d2733", "#e8edf3", ".body{{fill:none;stroke-width:2.2;stroke:{}}}"},
                                    {"#6d5a3a", "#d8c39a", ".chain{{fill:none;stroke-width:1.2;stroke:{}}}"},
                                    {"#8b95a1", "#7d8896", ".measure{{fill:none;stroke-width:0.9;stroke:{}}}"},
                                    {"#0b5fa5", "#7cc0ff", ".normal{{stroke-width:2;stroke:{0};fill:{0}}}"},
                                    {"#b34700", "#ffb27a", ".friction{{stroke-width:2;stroke:{0};fill:{0}}}"},
                                    {"#4a5563", "#c0cad6", ".load{{stroke-width:2;stroke:{0};fill:{0}}}"},
                                    {"#17663f", "#8fdcb0", ".moves{{stroke-width:2;stroke:{0};fill:{0}}}"},
                                    {"#0b5fa5", "#7cc0ff", ".acceleration{{stroke-width:1.4;stroke:{0};fill:{0}}}"},
                                    {"#8b95a1", "#7d8896", ".fit-open{{fill:{}}}"},
                                    {"#0b5fa5", "#7cc0ff", ".fit-stick{{fill:{}}}"},
                                    {"#b34700", "#ffb27a", ".fit-slide{{fill:{}}}"},
                                    {"#4d3a80", "#d9ccff", ".fit-smooth{{fill:{}}}"}}};

/// Those that only pictures of scenes in space have.
constexpr std::array<Ink, 9> space_inks{
    {{"#2a3644", "#c9d4e0", ".rim{{fill:none;stroke-width:1.1;stroke:{}}}"},
     {"#2a3644", "#c9d4e0", ".hidden{{fill:none;stroke-width:0.8;stroke-dasharray:1.5 3;stroke:{}}}"},
     {"#6d5a3a", "#d8c39a", ".joint{{fill:none;stroke-width:1.6;stroke-dasharray:7 2 2 2;stroke:{}}}"},
     {"#17663f", "#8fdcb0", ".velocity{{stroke-width:1.4;stroke:{0};fill:{0}}}"},
     {"#efece4", "#1d232b", ".floor{{stroke:none;fill:{}}}"},
     {"#1d2733", "#000000", ".shadow{{stroke:none;fill-opacity:0.22;fill:{}}}"},
     {"#4d3a80", "#d9ccff", ".cone{{stroke-width:0.9;fill-opacity:0.12;stroke:{0};fill:{0}}}"},
     {"#17663f", "#8fdcb0", ".slips{{stroke-width:1.4;stroke:{0};fill:{0}}}"},
     {"#17663f", "#8fdcb0", ".arc{{stroke-width:0.7;fill-opacity:0.25;stroke:{0};fill:{0}}}"}}};

/// The faces of solids, from those in the dark to those in the light; red, green, blue.
constexpr int shades = 16;
struct ShadeEnds {
  std::array<int, 3> dark, light;
};
constexpr ShadeEnds light_shades{{0x7f, 0x90, 0xa3}, {0xee, 0xf2, 0xf7}};
constexpr ShadeEnds dark_shades{{0x18, 0x21, 0x2b}, {0x68, 0x80, 0x9a}};

std::string shade_rule(int i, const ShadeEnds& ends) {
  const auto part = [&](std::size_t k) { return ends.dark[k] + (ends.light[k] - ends.dark[k]) * i / (shades - 1); };
  return fmt::format(".shade{0}{{fill:#{1:02x}{2:02x}{3:02x};stroke:#{1:02x}{2:02x}{3:02x};stroke-width:0.6}}\n", i,
                     part(0), part(1), part(2));
}

/// Rules for light displays, and those that replace them on dark ones.
struct Rules {
  std::string light, dark;

  void add(std::span<const Ink> all) {
    for (const Ink& ink : all) {
      light += fmt::format(fmt::runtime(ink.rule), ink.light) + "\n";
      dark += fmt::format(fmt::runtime(ink.rule), ink.dark) + "\n";
    }
  }
  std::string style() const { return light + "@media screen and (prefers-color-scheme:dark){\n" + dark + "}\n"; }
};

}  // namespace

std::string shade_class(double light) {
  return "shade" + std::to_string(static_cast<int>(std::clamp(light, 0.0, 0.999) * shades));
}

std::string picture_style() {
  Rules rules;
  for (std::size_t i = 0; i < mode_colours.size(); ++i) {
    rules.light += fmt::format(".m{}{{fill:{}}}\n", i, mode_colours[i].light);
    rules.dark += fmt::format(".m{}{{fill:{}}}\n", i, mode_colours[i].dark);
  }
  rules.add(inks);
  return rules.style();
}

std::string space_style() {
  Rules rules;
  for (int i = 0; i < shades; ++i) {
    rules.light += shade_rule(i, light_shades);
    rules.dark += shade_rule(i, dark_shades);
  }
  rules.add(space_inks);
  return rules.style();
}

ModeColours::ModeColours(std::vector<MechanismMode> modes) {
  std::sort(modes.begin(), modes.end());
  std::array<bool, mode_colours.size()> taken{};
  for (const MechanismMode& mode : modes) {
    if (indices_.contains(mode)) continue;
    std::size_t index = 0;
    for (const ElementState state : mode) index = (4 * index + static_cast<std::size_t>(state)) % taken.size();
    if (indices_.size() < taken.size()) {
      while (taken[index]) index = (index + 1) % taken.size();
    }
    taken[index] = true;
    indices_.emplace(mode, index);
  }
}

std::string ModeColours::fill_class(const MechanismMode& mode) const {
  return "m" + std::to_string(indices_.at(mode));
}

}  // namespace slipproof
