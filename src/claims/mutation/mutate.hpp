// All small changes of an expression. A verifier must notice each of them, unless the change has no effect.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/expression/expression.hpp"

namespace slipproof {

struct Mutant {
  Expression expression;
  std::string description;  ///< what was changed into what: `+ becomes -`
  std::size_t column = 0;   ///< where
};

/// All trees that differ from `expression` in one place; none occurs twice, and none equals `expression`. The changes:
/// a coefficient (also an unwritten 1); a sign; an operator; operands of - and / exchanged; an exponent; a symbol
/// replaced by each of `symbols`; a comparison made strict or not strict, or turned round; a link of a chain dropped;
/// `and` and `or` swapped; an operand of them dropped; `not` dropped.
std::vector<Mutant> mutants(const Expression& expression, const std::vector<std::string>& symbols);

}  // namespace slipproof
