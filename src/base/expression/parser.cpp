#include "base/expression/parser.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/expression/lexer.hpp"
#include "base/number/parse.hpp"

namespace slipproof {

namespace {

struct Function {
  std::string_view name;
  Operation operation;
  std::size_t arguments;
};
constexpr std::array<Function, 4> functions{{{"abs", Operation::absolute, 1},
                                             {"sign", Operation::signum, 1},
                                             {"min", Operation::minimum, 2},
                                             {"max", Operation::maximum, 2}}};
constexpr std::array<std::string_view, 5> reserved_words{"and", "or", "not", "true", "false"};

const Function* find_function(std::string_view name) {
  const auto found =
      std::find_if(functions.begin(), functions.end(), [&](const Function& function) { return function.name == name; });
  return found == functions.end() ? nullptr : found;
}

std::optional<Relation> as_relation(std::string_view text) {
  for (const Relation relation : {Relation::less, Relation::less_equal, Relation::greater, Relation::greater_equal,
                                  Relation::equal, Relation::not_equal}) {
    if (spelling(relation) == text) return relation;
  }
  return std::nullopt;
}

class Parser {
 public:
  explicit Parser(std::string_view text) : lexer_(text) {}

  Expression parse(Sort expected) {
    Expression expression = disjunction();
    if (!at_end()) fail_expecting("an operator or the end of the expression");
    require(expression, expected);
    return expression;
  }

 private:
  // Counts the open constructs; the tree's own depth is checked where it is built.
  struct Level {
    Level(Parser& parser, std::size_t column) : parser_(parser) {
      if (++parser_.level_ > max_expression_depth) parser_.fail_depth(column);
    }
    ~Level() { --parser_.level_; }
    Parser& parser_;
  };

  const Token& token() const { return lexer_.token(); }
  bool at_end() const { return token().kind == Token::Kind::end; }
  bool at(std::string_view text) const {
    return token().text == text && (token().kind == Token::Kind::punctuation || token().kind == Token::Kind::word);
  }
  bool accept(std::string_view text) {
    if (!at(text)) return false;
    lexer_.advance();
    return true;
  }
  void expect(std::string_view text) {
    if (!accept(text)) fail_expecting("`" + std::string(text) + "`");
  }

  [[noreturn]] void fail_expecting(const std::string& expected) const {
    throw ExpressionError(token().column, "found " + describe(token()) + ", expected " + expected);
  }
  [[noreturn]] void fail_depth(std::size_t column) const {
    throw ExpressionError(column, "nested more than " + std::to_string(max_expression_depth) + " levels deep");
  }

  static void require(const Expression& expression, Sort expected) {
    if (sort(*expression) == expected) return;
    throw ExpressionError(expression->column, expected == Sort::number
                                                  ? "found a comparison or truth value, expected a number"
                                                  : "found a number, expected a comparison or truth value");
  }

  Expression build(Operation operation, std::vector<Expression> operands, Sort of_operands, std::size_t column) {
    for (const Expression& operand : operands) require(operand, of_operands);
    return bounded(make(operation, std::move(operands), column));
  }
  Expression bounded(Expression expression) const {
    if (expression->depth > max_expression_depth) fail_depth(expression->column);
    return expression;
  }

  Expression disjunction() {
    Expression left = conjunction();
    for (std::size_t column = token().column; accept("or"); column = token().column) {
      Expression right = conjunction();
      left = build(Operation::logical_or, {std::move(left), std::move(right)}, Sort::truth, column);
    }
    return left;
  }

  Expression conjunction() {
    Expression left = negation();
    for (std::size_t column = token().column; accept("and"); column = token().column) {
      Expression right = negation();
      left = build(Operation::logical_and, {std::move(left), std::move(right)}, Sort::truth, column);
    }
    return left;
  }

  Expression negation() {
    const std::size_t column = token().column;
    if (!accept("not")) return comparison();
    const Level level(*this, column);
    return build(Operation::logical_not, {negation()}, Sort::truth, column);
  }

  Expression comparison() {
    std::vector<Expression> operands{sum()};
    std::vector<Relation> relations;
    const std::size_t column = token().column;
    while (const auto relation = token().kind == Token::Kind::punctuation ? as_relation(token().text) : std::nullopt) {
      lexer_.advance();
      relations.push_back(*relation);
      operands.push_back(sum());
    }
    if (relations.empty()) return std::move(operands.front());
    for (const Expression& operand : operands) require(operand, Sort::number);
    return bounded(make_comparison(std::move(operands), std::move(relations), column));
  }

  Expression sum() {
    Expression left = product();
    for (;;) {
      const std::size_t column = token().column;
      const Operation operation = at("+") ? Operation::add : Operation::subtract;
      if (!accept("+") && !accept("-")) return left;
      Expression right = product();
      left = build(operation, {std::move(left), std::move(right)}, Sort::number, column);
    }
  }

  Expression product() {
    Expression left = unary();
    for (;;) {
      const std::size_t column = token().column;
      const Operation operation = at("*") ? Operation::multiply : Operation::divide;
      if (!accept("*") && !accept("/")) return left;
      Expression right = unary();
      left = build(operation, {std::move(left), std::move(right)}, Sort::number, column);
    }
  }

  Expression unary() {
    const std::size_t column = token().column;
    if (!accept("-")) return power();
    const Level level(*this, column);
    return build(Operation::negate, {unary()}, Sort::number, column);
  }

  Expression power() {
    Expression base = primary();
    const std::size_t column = token().column;
    if (!accept("^")) return base;
    require(base, Sort::number);
    const int exponent = this->exponent();
    if (at("^")) fail_expecting("parentheses: `x^2^3` reads two ways");
    return bounded(make_power(std::move(base), exponent, column));
  }

  int exponent() {
    const bool parentheses = accept("(");
    const bool negative = accept("-");
    if (token().kind != Token::Kind::number) fail_expecting("an integer exponent");
    const Rational value = number();
    if (denominator(value) != 1) {
      throw ExpressionError(token().column,
                            "found the exponent " + std::string(token().text) + ", expected an integer");
    }
    if (value > max_exponent) {
      throw ExpressionError(token().column, "found the exponent " + std::string(token().text) +
                                                ", expected one of at most " + std::to_string(max_exponent));
    }
    lexer_.advance();
    if (parentheses) expect(")");
    const int magnitude = static_cast<int>(numerator(value).to_long());
    return negative ? -magnitude : magnitude;
  }

  Rational number() const {
    try {
      return parse_rational(token().text);
    } catch (const NumberError& error) {
      throw ExpressionError(token().column + error.position(), error.what());
    }
  }

  Expression primary() {
    const std::size_t column = token().column;
    if (token().kind == Token::Kind::number) {
      Expression literal = make_number(number(), column);
      lexer_.advance();
      return literal;
    }
    if (accept("true")) return make_truth(true, column);
    if (accept("false")) return make_truth(false, column);
    if (accept("(")) {
      const Level level(*this, column);
      Expression inside = disjunction();
      expect(")");
      return inside;
    }
    if (token().kind == Token::Kind::word &&
        std::find(reserved_words.begin(), reserved_words.end(), token().text) == reserved_words.end()) {
      return symbol_or_call();
    }
    fail_expecting("a number, a symbol or `(`");
  }

  Expression symbol_or_call() {
    const Token name = token();
    const Function* function = find_function(name.text);
    lexer_.advance();
    if (!at("(")) {
      if (function) fail_expecting("`(` after the function `" + std::string(name.text) + "`");
      return make_symbol(std::string(name.text), name.column);
    }
    if (!function) {
      throw ExpressionError(name.column, "found `" + std::string(name.text) +
                                             "(`, expected one of the functions abs, sign, min, max (a product is "
                                             "written with `*`)");
    }
    const Level level(*this, name.column);
    std::vector<Expression> arguments;
    do {
      lexer_.advance();
      arguments.push_back(disjunction());
    } while (at(",") && arguments.size() < function->arguments);
    if (arguments.size() < function->arguments) fail_expecting("`,` and a second argument");
    expect(")");
    return build(function->operation, std::move(arguments), Sort::number, name.column);
  }

  Lexer lexer_;
  std::size_t level_ = 0;
};

}  // namespace

Expression parse_expression(std::string_view text, Sort expected) {
  if (text.size() > max_expression_length) {
    throw ExpressionError(max_expression_length + 1, "found an expression of " + std::to_string(text.size()) +
                                                         " characters, expected at most " +
                                                         std::to_string(max_expression_length));
  }
  return Parser(text).parse(expected);
}

bool is_symbol_name(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto follows = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !text.empty() && letter(text.front()) && std::all_of(text.begin(), text.end(), follows) &&
         std::find(reserved_words.begin(), reserved_words.end(), text) == reserved_words.end() &&
         find_function(text) == nullptr;
}

}  // namespace slipproof
