// Expressions of claims files as MathML.
#pragma once

#include <string_view>

#include "base/expression/expression.hpp"
#include "base/number/rational.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// Adds the expression as one or more <math>, with the words `and` and `or` between them; lines may break between
/// <math>.
void add_math(const Element& parent, const Expression& expression);

/// Adds `symbol = expression`.
void add_definition(const Element& parent, std::string_view symbol, const Expression& expression);

/// Adds a symbol, or a number as a fraction, to a <math> or <mrow>.
void add_symbol(const Element& row, std::string_view name);
void add_number(const Element& row, const Rational& value);

/// Adds an empty <math>.
Element add_math(const Element& parent);
/// Adds an operator to a <math> or <mrow>.
void add_operator(const Element& row, std::string_view sign);

}  // namespace slipproof
