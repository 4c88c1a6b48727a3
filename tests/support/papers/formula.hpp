// Formulas of the claims language, from text.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "base/expression/evaluate.hpp"
#include "base/expression/parser.hpp"

namespace slipproof::test {

inline Expression number(const std::string& text) {
  return parse_expression(text, Sort::number);
}
inline Expression truth(const std::string& text) {
  return parse_expression(text, Sort::truth);
}

/// The symbols are numbered in their order.
inline Program compile(const Expression& expression, const std::vector<std::string>& symbols) {
  return Program(expression, [&](std::string_view name) -> std::optional<std::size_t> {
    const auto at = std::find(symbols.begin(), symbols.end(), name);
    if (at == symbols.end()) return std::nullopt;
    return static_cast<std::size_t>(at - symbols.begin());
  });
}

}  // namespace slipproof::test
