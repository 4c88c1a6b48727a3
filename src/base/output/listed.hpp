// Joins names to a list: `stick/stick, lift/lift`.
#pragma once

#include <string>
#include <string_view>

namespace slipproof {

/// `name(x)` for each x of the range, with `between` between them.
template <class Range, class Name>
requires requires(const Range& range, const Name& name) {
  name(*range.begin());
}
std::string listed(const Range& range, const Name& name, std::string_view between = ", ") {
  std::string text;
  bool first = true;
  for (const auto& one : range) {
    if (!first) text += between;
    first = false;
    text += name(one);
  }
  return text;
}

/// Joins texts.
template <class Range>
std::string listed(const Range& texts, std::string_view between = ", ") {
  return listed(
      texts, [](const auto& text) { return text; }, between);
}

}  // namespace slipproof
