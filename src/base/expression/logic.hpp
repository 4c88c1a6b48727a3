// Conditions: negated, joined, and closed.
#pragma once

#include <vector>

#include "base/expression/expression.hpp"

namespace slipproof {

/// The negation, undefined where the condition is. Negates the comparisons and exchanges `and` and `or`, so that the
/// result contains no new `not`.
Expression opposite(const Expression& truth);

/// The closed condition (proofs/MEANING.md, Unique): moves each `not` inwards to the comparisons, then replaces `<` by
/// `<=`, `>` by `>=`, and `x != y` by `x <= y or x >= y`.
Expression closure(const Expression& truth);

bool is_true(const Expression& truth);  ///< true for the literal `true`

/// Returns `x and y`; if one of them is `true`, the other.
Expression conjunction(const Expression& x, const Expression& y);
/// Joins conditions by `and`; null for an empty list.
Expression all_of(const std::vector<Expression>& truths);
/// The conjuncts of all conditions in one list. Splits chains of comparisons into links, does not split `or` and `not`,
/// and omits `true`.
std::vector<Expression> conjuncts(const std::vector<Expression>& truths);

}  // namespace slipproof
