// Sums and products of expressions without what says nothing: + 0, * 1, - -.
#pragma once

#include "expression/expression.hpp"

namespace slipproof {

Expression zero_literal();
Expression sum_of(const Expression& x, const Expression& y);
/// x + y without brackets around y: a tree as deep as y has terms, to be read rather than evaluated.
Expression appended(const Expression& x, const Expression& y);
Expression difference_of(const Expression& x, const Expression& y);
Expression negative_of(const Expression& x);
Expression product_of(const Expression& x, const Expression& y);
Expression quotient_of(const Expression& x, const Expression& y);
/// By a symbol that stands under no division and in no function; where it does, that part stands for its derivative.
Expression derivative_of(const Expression& x, std::string_view symbol);

}  // namespace slipproof
