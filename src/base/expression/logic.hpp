// Conditions turned round, joined, and with their ends.
#pragma once

#include <vector>

#include "base/expression/expression.hpp"

namespace slipproof {

/// What is true where the condition is false, false where it is true, and undefined where it is: comparisons turned
/// round, `and` and `or` exchanged. There is no `not` in it.
Expression opposite(const Expression& truth);

/// The condition with its ends (proofs/MEANING.md, Unique): each `not` carried inwards to the comparisons, then `<`
/// read as `<=`, `>` as `>=`, and `x != y` as `x <= y or x >= y`.
Expression closure(const Expression& truth);

bool is_true(const Expression& truth);  ///< the word `true`

/// `x and y`, where one of them may be `true`.
Expression conjunction(const Expression& x, const Expression& y);
/// Joined by `and`; null for none.
Expression all_of(const std::vector<Expression>& truths);
/// The conjuncts of all of the conditions together: chains of comparisons link by link, anything under `or` and `not`
/// as a whole, and no `true`.
std::vector<Expression> conjuncts(const std::vector<Expression>& truths);

}  // namespace slipproof
