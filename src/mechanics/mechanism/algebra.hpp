// Sums and products of expressions without what says nothing: + 0, * 1, - -.
#pragma once

#include "base/expression/cases.hpp"

namespace slipproof {

Expression zero_literal();

// x - x and 0*x are 0 only where x has a value: `defined` says of an expression that it has one everywhere.
Expression sum_of(const Expression& x, const Expression& y, const OfExpression& defined = has_no_division);
Expression difference_of(const Expression& x, const Expression& y, const OfExpression& defined = has_no_division);
Expression product_of(const Expression& x, const Expression& y, const OfExpression& defined = has_no_division);

/// x + y without brackets around y: a tree as deep as y has terms, to be read rather than evaluated.
Expression appended(const Expression& x, const Expression& y);
Expression negative_of(const Expression& x);
Expression quotient_of(const Expression& x, const Expression& y);
/// With numbers in place of quotients and products of numbers: 0.6 for 3/5. What divides by 0 stays as it is.
Expression folded(const Expression& x);
/// The derivative by a symbol that occurs under no division and in no function; a part where it does is returned in
/// place of its derivative.
Expression derivative_of(const Expression& x, std::string_view symbol);

}  // namespace slipproof
