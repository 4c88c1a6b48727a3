// Every single small change of an expression: what a verifier must notice, unless the change changes nothing.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/expression/expression.hpp"

namespace slipproof {

struct Mutant {
  Expression expression;
  std::string description;  ///< what was changed into what, `+ becomes -`
  std::size_t column = 0;   ///< where
};

/// All trees that differ from `expression` in one place, none twice and none the same as it:
/// a coefficient changed (also an unwritten 1), a sign flipped, an operator swapped, operands of - and / exchanged, an
/// exponent changed, a symbol swapped with each of `symbols`, a comparison made strict or not strict or turned round,
/// a link of a chain dropped, `and` and `or` swapped, an operand of them dropped, `not` dropped.
std::vector<Mutant> mutants(const Expression& expression, const std::vector<std::string>& symbols);

}  // namespace slipproof
