// How large an expression becomes when its definitions are written out: what bounds the work of evaluating it, the size
// of the numbers, and the stack.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "base/expression/expression.hpp"

namespace slipproof {

struct Extent {
  double terms = 1;  ///< literals (by their length) and symbols, counted as often as they are multiplied
  std::size_t depth = 1;
};

/// The extent of a symbol's definition; nothing for a symbol without one.
using ExtentOfDefinition = std::function<std::optional<Extent>(const std::string& symbol)>;
Extent extent(const Expression& expression, const ExtentOfDefinition& of_definition);

/// Why an expression is too large to evaluate: more than 10000 terms, or nested more than 1000 levels deep. Empty if it
/// is not.
std::string too_large(const Extent& extent);

}  // namespace slipproof
