// Expressions: rational arithmetic, comparisons and logic, as immutable trees that remember their
// columns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof {

enum class Operation : std::uint8_t {
  // numbers
  number,
  symbol,
  negate,
  add,
  subtract,
  multiply,
  divide,
  power,  ///< the exponent is a fixed integer
  absolute,
  signum,  ///< -1, 0 or +1
  minimum,
  maximum,
  // truth values
  truth,    ///< `true` or `false`
  compare,  ///< a chain such as `0 < b <= b1`: every link holds
  logical_not,
  logical_and,
  logical_or
};

/// The type of the value of an expression.
enum class Sort : std::uint8_t { number, truth };

enum class Relation : std::uint8_t { less, less_equal, greater, greater_equal, equal, not_equal };

std::string_view spelling(Relation relation);  ///< `<`, `<=`, ...
/// Whether `left relation right` holds, given the sign of left - right.
bool holds(Relation relation, int sign_of_difference);

struct Node;
/// A tree; copying shares it. Never null where an expression is expected.
using Expression = std::shared_ptr<const Node>;

struct Node {
  Operation operation = Operation::truth;
  std::size_t column = 0;            ///< position in the text it was read from, from 1; not part of its value
  std::vector<Expression> operands;  ///< one, two, or one more than `relations`
  std::vector<Relation> relations;   ///< relations of a comparison
  Rational number;                   ///< value of a literal, >= 0
  std::string symbol;                ///< name
  int exponent = 0;
  bool truth = false;
  std::size_t depth = 1;  ///< height of the tree, in nodes
};

Sort sort(const Node& node);

Expression make_number(Rational value, std::size_t column = 0);  ///< a negative value becomes the negation of a literal
Expression make_symbol(std::string name, std::size_t column = 0);
Expression make_truth(bool value, std::size_t column = 0);
Expression make_power(Expression base, int exponent, std::size_t column = 0);
Expression make_comparison(std::vector<Expression> operands, std::vector<Relation> relations, std::size_t column = 0);
/// Makes a node of any other operation.
Expression make(Operation operation, std::vector<Expression> operands, std::size_t column = 0);

/// Whether the trees are the same, ignoring columns.
bool same(const Expression& a, const Expression& b);

/// Text that reads back as the same tree, with as few parentheses as possible.
std::string to_string(const Expression& expression);

/// Precedence of an operation, loosest first, as in the grammar of parser.hpp.
enum class Binding : std::uint8_t {
  loosest,
  disjunction,
  conjunction,
  negation,
  comparison,
  sum,
  product,
  unary,
  primary
};
Binding binding(Operation operation);
Binding tighter(Binding binding);  ///< the next

bool is_symbol(const Expression& expression, std::string_view name);
/// The names of its symbols, without repetition, in the order of the text.
std::vector<std::string> symbols(const Expression& expression);

/// Whether a number, as written, is a polynomial of degree at most 1 in the symbol.
bool is_linear_in(const Expression& number, const std::string& symbol);

/// Replaces every occurrence of a symbol.
Expression substitute(const Expression& expression, std::string_view symbol, const Expression& by);
/// Replaces all symbols at once by their expressions; null leaves a symbol as it is.
Expression substitute(const Expression& expression, const std::function<Expression(const std::string&)>& meaning);

}  // namespace slipproof
