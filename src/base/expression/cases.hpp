// Conditions without functions: abs, sign, min and max as cases.
//
// What compares with max(x, y) compares with x where x >= y, and with y where x < y. With a function of the force in
// it, or in a statement, which has no word for functions, a condition is easier to judge as such cases. They say the
// same, also where something has no value: the case itself compares both operands.
#pragma once

#include <functional>
#include <vector>

#include "base/expression/expression.hpp"

namespace slipproof {

using OfExpression = std::function<bool(const Expression&)>;

/// Whether abs, sign, min or max is at the root, or occurs.
bool is_function(const Expression& e);
bool has_function(const Expression& e);
/// Of what is written without a division.
bool has_no_division(const Expression& e);
/// All that it divides by, bases of negative powers among it: it has a value where none of them is 0. What stands
/// within a divisor comes before it.
std::vector<Expression> divisors(const Expression& e);

/// The condition without the functions that are `wanted`. `defined` says of an expression that it has a value wherever
/// the condition may be used; then less has to be said. Null where it takes more than 256 cases.
Expression by_cases(const Expression& truth, const OfExpression& wanted, const OfExpression& defined);

}  // namespace slipproof
