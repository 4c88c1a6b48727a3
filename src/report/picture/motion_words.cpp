#include "report/picture/motion_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/input/utf8.hpp"
#include "base/number/format.hpp"
#include "base/number/parse.hpp"
#include "report/markup/symbol.hpp"

namespace slipproof {

std::optional<Rational> shown_value(const Range& range) {
  if (range.lower && range.upper) return Rational((*range.lower + *range.upper) / 2);
  return range.lower ? range.lower : range.upper;
}

namespace {

constexpr std::size_t longest_fraction = 9, longest_end = 6;
constexpr int digits = 4, digits_of_ends = 3;

std::string with_minus(std::string text) {
  if (text[0] == '-') text.replace(0, 1, "−");
  return text;
}

}  // namespace

NumberWords::NumberWords(const std::vector<Range>& shown) {
  for (const Range& range : shown) {
    const std::size_t longest = range.is_point() ? longest_fraction : longest_end;
    for (const auto& end : {range.lower, range.upper}) {
      fractions_ = fractions_ && (!end || exact_text(*end).size() <= longest);
    }
  }
}

std::string NumberWords::label(const Rational& x) const {
  if (fractions_) return with_minus(exact_text(x));
  const std::string decimal = decimal_text(x, digits);
  return (parse_rational(decimal) == x ? "" : "≈ ") + with_minus(decimal);
}

std::string NumberWords::value(const Rational& x) const {
  const std::string text = label(x);
  return text.starts_with("≈") ? text : "= " + text;
}

std::string NumberWords::range(const Range& range) const {
  if (range.is_point()) return value(*range.lower);
  bool exact = true;
  const auto end = [&](const Rational& x) {
    if (fractions_) return with_minus(exact_text(x));
    const std::string text = decimal_text(x, digits_of_ends);
    exact = exact && parse_rational(text) == x;
    return with_minus(text);
  };
  const std::string ends =
      (range.lower ? "[" + end(*range.lower) : "(−∞") + ", " + (range.upper ? end(*range.upper) + "]" : "∞)");
  return (exact ? "in " : "in ≈ ") + ends;
}

std::string load_text(const MechanismScene& scene, const NumberWords& numbers) {
  const std::string& unit = scene.mechanism.load->unit;
  return plain_symbol(scene.mechanism.load->symbol) + " " + numbers.value(*scene.load) +
         (unit.empty() || unit == "1" ? "" : " " + unit);
}

std::string counted_motions(const MotionsAtLoad& found) {
  const std::size_t continua = found.continua.size();
  if (continua == 0) return counted(found.motions.size(), "motion");
  const auto alone = static_cast<std::size_t>(
      std::ranges::count_if(found.motions, [](const MotionAtLoad& motion) { return motion.continua.empty(); }));
  const std::size_t inside = found.motions.size() - alone;
  std::string text = alone > 0 ? counted(alone, "motion") + ", " : "";
  text += continua == 1 ? "1 continuum of motions" : fmt::format("{} continua of motions", continua);
  if (inside > 0) {
    text += fmt::format(", with {} of other modes in {}", counted(inside, "motion"), continua == 1 ? "it" : "them");
  }
  return text;
}

std::size_t gap_index(const Mechanism& mechanism, std::size_t contact) {
  std::size_t index = mechanism.accelerations;
  for (std::size_t i = 0; i < contact; ++i) index += mechanism.contacts[i].slip ? 2 : 1;
  return index;
}

std::vector<Range> shown_numbers(const MechanismScene& scene, const MotionAtLoad* motion) {
  std::vector<Range> shown;
  if (motion != nullptr) {
    shown = motion->forces;
    const auto names = acceleration_names(scene.mechanism);
    for (const MechanismShape& shape : scene.mechanism.shapes) {
      if (shape.acceleration.empty()) continue;
      const auto at = std::ranges::find(names, shape.acceleration) - names.begin();
      const Rational& value = motion->accelerations[static_cast<std::size_t>(at)];
      shown.push_back({value, value});
    }
  }
  if (scene.mechanism.load && scene.load) shown.push_back({scene.load, scene.load});
  return shown;
}

std::string common_state(const MotionAtLoad& motion, std::size_t element) {
  const auto& modes = motion.strict() ? motion.modes : motion.boundary_modes;
  const auto same = [&](const MechanismMode& mode) { return mode[element] == modes.front()[element]; };
  if (modes.empty() || !std::all_of(modes.begin(), modes.end(), same)) return {};
  return std::string(name(modes.front()[element]));
}

std::string short_name(const MechanismMode& mode) {
  constexpr std::size_t longest = 60;
  const std::string whole = name(mode);
  if (whole.size() <= longest) return whole;
  std::vector<std::pair<ElementState, int>> counts;
  for (const ElementState state : mode) {
    const auto known = std::ranges::find(counts, state, [](const auto& one) { return one.first; });
    known == counts.end() ? counts.emplace_back(state, 1), void() : void(++known->second);
  }
  std::vector<std::string> words;
  for (const auto& [state, count] : counts) words.push_back(fmt::format("{} {}", count, name(state)));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string modes_text(const MotionAtLoad& motion) {
  constexpr std::size_t longest = 34;  // letters, with the last mode beyond them: a heading as wide as a picture
  std::vector<std::string> names;
  std::size_t letters = 0;
  for (const MechanismMode& mode : motion.strict() ? motion.modes : motion.boundary_modes) {
    if (!names.empty() && letters + short_name(mode).size() > longest) {
      names.emplace_back("…");
      break;
    }
    names.push_back(short_name(mode));
    letters += names.back().size();
  }
  return fmt::format("{}{}", fmt::join(names, " = "), motion.strict() ? "" : " (boundary)");
}

const Range& range_of_force(const MechanismScene& scene, const MotionAtLoad& motion, std::size_t unknown) {
  return motion.forces[unknown - scene.mechanism.accelerations];
}

std::string contact_text(const MechanismScene& scene, const MotionAtLoad* motion, std::size_t contact) {
  const std::string state = motion == nullptr ? std::string() : common_state(*motion, contact);
  return scene.mechanism.contacts[contact].name + (state.empty() ? "" : ": " + state);
}

std::vector<std::string> told_of(const MechanismScene& scene, const MotionAtLoad* motion,
                                 const std::vector<bool>& drawn, const NumberWords& numbers) {
  const Mechanism& mechanism = scene.mechanism;
  std::vector<std::string> parts;
  if (mechanism.load && scene.load) parts.push_back(load_text(scene, numbers));
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    if (mechanism.contacts[i].at.empty()) parts.push_back(contact_text(scene, motion, i) + " (has no place)");
  }
  if (motion == nullptr) return parts;
  for (std::size_t i = 0; i < mechanism.friction.size(); ++i) {
    const std::string state = common_state(*motion, mechanism.contacts.size() + i);
    if (!state.empty()) parts.push_back(mechanism.friction[i].name + ": " + state);
  }
  using Role = MechanismUnknown::Role;
  for (std::size_t i = mechanism.accelerations; i < mechanism.unknowns.size(); ++i) {
    const MechanismUnknown& unknown = mechanism.unknowns[i];
    const bool of_contact = unknown.role == Role::normal || unknown.role == Role::tangent;
    if (!of_contact || !drawn[unknown.owner])
      parts.push_back(plain_symbol(unknown.symbol) + " " + numbers.range(range_of_force(scene, *motion, i)));
  }
  return parts;
}

std::vector<std::string> caption_lines(const std::vector<std::string>& pieces, std::size_t length) {
  constexpr std::string_view between = ", ";
  std::vector<std::string> lines;
  for (const std::string& piece : pieces) {
    const bool fits = !lines.empty() && utf8_count(lines.back()) + between.size() + utf8_count(piece) <= length;
    fits ? lines.back() += std::string(between) + piece : lines.emplace_back(piece);
  }
  return lines;
}

}  // namespace slipproof
