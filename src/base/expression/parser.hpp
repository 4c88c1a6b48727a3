// Reading expressions.
//
//   truth      := conjunction ("or" conjunction)*
//   conjunction:= negation ("and" negation)*
//   negation   := "not" negation | comparison
//   comparison := sum (("<" | "<=" | ">" | ">=" | "=" | "!=") sum)*        every link holds: 0 < b <= b1
//   sum        := product (("+" | "-") product)*
//   product    := unary (("*" | "/") unary)*
//   unary      := "-" unary | power
//   power      := primary ("^" ["-"] INTEGER)?                            -x^2 is -(x^2)
//   primary    := NUMBER | SYMBOL | "true" | "false" | "(" truth ")"
//               | ("abs" | "sign") "(" sum ")" | ("min" | "max") "(" sum "," sum ")"
//
// A NUMBER is exact, in the forms of number/parse.hpp without sign and fraction; a SYMBOL is a letter followed by
// letters, digits and underscores. Products are written out: `2*b`, not `2b`.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/expression/expression.hpp"

namespace slipproof {

/// The first mistake in the text of an expression.
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(std::size_t column, const std::string& message) : std::runtime_error(message), column_(column) {}
  std::size_t column() const { return column_; }  ///< from 1, in bytes of the text

 private:
  std::size_t column_;
};

/// Limits on length and depth, far above what people write, so that no text exhausts the stack.
inline constexpr std::size_t max_expression_length = 10'000;
inline constexpr std::size_t max_expression_depth = 200;
inline constexpr int max_exponent = 64;

/// Reads an expression of the given sort. Throws ExpressionError.
Expression parse_expression(std::string_view text, Sort expected);

/// Whether the text can name a symbol: a letter, then letters, digits and underscores, and no word of the language.
bool is_symbol_name(std::string_view text);

}  // namespace slipproof
