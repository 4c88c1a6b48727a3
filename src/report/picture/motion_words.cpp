#include "report/picture/motion_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "base/number/format.hpp"
#include "report/picture/drawing.hpp"

namespace slipproof {

std::optional<Rational> shown_value(const Range& range) {
  if (range.lower && range.upper) return Rational((*range.lower + *range.upper) / 2);
  return range.lower ? range.lower : range.upper;
}

std::string value_text(const Rational& x) {
  const std::string value = label_value(x);
  return value.starts_with("≈") ? value : "= " + value;
}

std::string range_text(const Range& range) {
  if (range.is_point()) return value_text(*range.lower);
  bool exact = true;
  const auto end = [&](const Rational& x) {
    std::string text = exact_text(x);
    if (text.size() > 6) text = decimal_text(x, 3), exact = false;
    if (text[0] == '-') text.replace(0, 1, "−");
    return text;
  };
  const std::string ends =
      (range.lower ? "[" + end(*range.lower) : "(−∞") + ", " + (range.upper ? end(*range.upper) + "]" : "∞)");
  return (exact ? "in " : "in ≈ ") + ends;
}

std::string common_state(const MotionAtLoad& motion, std::size_t element) {
  const auto& modes = motion.strict() ? motion.modes : motion.boundary_modes;
  const auto same = [&](const MechanismMode& mode) { return mode[element] == modes.front()[element]; };
  if (!std::all_of(modes.begin(), modes.end(), same)) return {};
  return std::string(name(modes.front()[element]));
}

std::string modes_text(const MotionAtLoad& motion) {
  std::vector<std::string> names;
  for (const MechanismMode& mode : motion.strict() ? motion.modes : motion.boundary_modes) names.push_back(name(mode));
  if (names.size() > 3) names.resize(3), names.emplace_back("…");
  return fmt::format("{}{}", fmt::join(names, " = "), motion.strict() ? "" : " (boundary)");
}

}  // namespace slipproof
