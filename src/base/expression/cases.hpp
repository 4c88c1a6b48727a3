// Conditions without functions: abs, sign, min and max written as cases.
//
// A comparison with max(x, y) is one with x if x >= y, and one with y if x < y. If a function contains the force, or if
// a statement is to be written, whose language has no functions, a condition is easier to judge as such cases. They say
// the same, also where something has no value: the case itself compares both operands.
#pragma once

#include <functional>
#include <vector>

#include "base/expression/expression.hpp"

namespace slipproof {

using OfExpression = std::function<bool(const Expression&)>;

/// Whether abs, sign, min or max is at the root, or occurs.
bool is_function(const Expression& e);
bool has_function(const Expression& e);
/// True if the expression as written has no division and no negative power.
bool has_no_division(const Expression& e);
/// All divisors of an expression, including bases of negative powers. The expression has a value if none of them is 0.
/// Divisors inside a divisor precede it.
std::vector<Expression> divisors(const Expression& e);

/// The condition without the functions that are `wanted`. `defined` says whether an expression has a value wherever the
/// condition may be used; then the cases need not say so. Null if it takes more than 256 cases.
Expression by_cases(const Expression& truth, const OfExpression& wanted, const OfExpression& defined);

}  // namespace slipproof
