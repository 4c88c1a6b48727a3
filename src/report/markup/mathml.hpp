// Expressions of claims files as MathML.
#pragma once

#include <string_view>

#include "base/expression/expression.hpp"
#include "base/number/rational.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// The expression as one or more <math>, with the words `and` and `or` between them; lines may break where they meet.
void add_math(const Element& parent, const Expression& expression);

/// `symbol = expression`.
void add_definition(const Element& parent, std::string_view symbol, const Expression& expression);

/// A symbol, or a number as a fraction, inside an <math> or <mrow>.
void add_symbol(const Element& row, std::string_view name);
void add_number(const Element& row, const Rational& value);

/// An empty <math> to fill.
Element add_math(const Element& parent);
/// An operator inside one.
void add_operator(const Element& row, std::string_view sign);

}  // namespace slipproof
