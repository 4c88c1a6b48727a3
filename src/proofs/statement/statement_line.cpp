#include "proofs/statement/statement_line.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/number/rational.hpp"

namespace slipproof {

namespace {

// As in the checker.
constexpr int max_nesting = 100, max_operators = 1'000;
constexpr std::size_t max_name = 100, max_digits = 2'500;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_in_word(char c) {
  return is_letter(c) || is_digit(c) || c == '_' || c == '\'' || c == '.';
}

std::optional<Relation> relation(std::string_view text) {
  for (const Relation known : {Relation::less, Relation::less_equal, Relation::greater, Relation::greater_equal,
                               Relation::equal, Relation::not_equal}) {
    if (text == spelling(known)) return known;
  }
  return std::nullopt;
}

}  // namespace

StatementLine::StatementLine(std::string_view line, const GivenNames& given) : given_(given), end_(line.size() + 1) {
  for (std::size_t i = 0; i < line.size();) {
    const auto first = line.begin() + static_cast<std::ptrdiff_t>(i);
    std::size_t size = static_cast<std::size_t>(std::find_if_not(first, line.end(), is_in_word) - first);
    if (size == 0)
      size = i + 1 < line.size() && line[i + 1] == '=' && std::string_view("<>!").find(line[i]) < 3 ? 2 : 1;
    if (line[i] != ' ') tokens_.push_back({line.substr(i, size), i + 1});
    i += size;
  }
}

std::size_t StatementLine::column() const {
  return at_end() ? end_ : tokens_[next_].column;
}

void StatementLine::fail(const std::string& expected) const {
  constexpr std::size_t shown = 40;
  std::string found(peek().substr(0, shown));
  found = found.empty() ? "the end of the line" : "`" + found + (peek().size() > shown ? "...`" : "`");
  throw ExpressionError(column(), "found " + found + ", expected " + expected);
}

bool StatementLine::accept(std::string_view token) {
  if (at_end() || peek() != token) return false;
  ++next_;
  return true;
}

void StatementLine::expect(std::string_view token) {
  if (!accept(token)) fail("`" + std::string(token) + "`");
}

void StatementLine::expect_end() const {
  if (!at_end()) fail("the end of the line");
}

std::string StatementLine::name() {
  if (at_end() || !is_letter(peek().front())) fail("a name: a letter, then letters, digits, `_`, `'` and `.`");
  if (peek().size() > max_name) fail("a name of at most 100 characters");
  return take();
}

void StatementLine::count_operator() {
  if (++operators_ > max_operators) throw ExpressionError(column(), "the expression has more than 1000 operators");
}

/// The contents of brackets. A failure ends the reading, so the depth need not come down after one.
template <class Read>
Expression StatementLine::nested(const char* closing, Read read) {
  if (++nesting_ > max_nesting) throw ExpressionError(tokens_[next_ - 1].column, "more than 100 levels of brackets");
  Expression result = read();
  expect(closing);
  --nesting_;
  return result;
}

Expression StatementLine::joined(Operation operation, std::vector<Expression> parts, std::size_t column) const {
  return parts.size() == 1 ? std::move(parts.front()) : make(operation, std::move(parts), column);
}

Expression StatementLine::formula() {
  const std::size_t start = column();
  std::vector<Expression> parts;
  do parts.push_back(conjunction());
  while (accept("or"));
  return joined(Operation::logical_or, std::move(parts), start);
}

Expression StatementLine::conjunction() {
  const std::size_t start = column();
  std::vector<Expression> parts;
  do parts.push_back(unit());
  while (accept("and"));
  return joined(Operation::logical_and, std::move(parts), start);
}

Expression StatementLine::unit() {
  const std::size_t start = column();
  if (accept("{")) return nested("}", [this] { return formula(); });
  if (accept("false")) return make_truth(false, start);
  if (given_.formulas.contains(peek())) return make_symbol(take(), start);
  return comparison();
}

Expression StatementLine::comparison() {
  const std::size_t start = column();
  std::vector<Expression> operands{expression()};
  std::vector<Relation> relations;
  while (const auto next = relation(peek())) {
    ++next_;
    relations.push_back(*next);
    operands.push_back(expression());
  }
  if (relations.empty()) fail("a comparison: one of < <= = != >= >");
  return make_comparison(std::move(operands), std::move(relations), start);
}

Expression StatementLine::expression() {
  operators_ = 0;
  return sum();
}

Expression StatementLine::sum() {
  Expression result = product();
  while (true) {
    const std::size_t start = column();
    const bool minus = accept("-");
    if (!minus && !accept("+")) return result;
    count_operator();
    result = make(minus ? Operation::subtract : Operation::add, {std::move(result), product()}, start);
  }
}

Expression StatementLine::product() {
  Expression result = power();
  while (true) {
    const std::size_t start = column();
    const bool divide = accept("/");
    if (!divide && !accept("*")) return result;
    count_operator();
    result = make(divide ? Operation::divide : Operation::multiply, {std::move(result), power()}, start);
  }
}

Expression StatementLine::power() {
  const std::size_t start = column();
  bool minus = false;
  while (accept("-")) minus = !minus;
  Expression result = base();
  if (accept("^")) result = make_power(std::move(result), exponent(), start);
  return minus ? make(Operation::negate, {std::move(result)}, start) : result;
}

Expression StatementLine::base() {
  const std::size_t start = column();
  if (accept("(")) return nested(")", [this] { return sum(); });
  if (given_.values.contains(peek())) return make_symbol(take(), start);
  if (!at_end() && std::all_of(peek().begin(), peek().end(), is_digit)) {
    if (peek().size() > 1 && peek().front() == '0') fail("a number that does not begin with zero");
    if (peek().size() > max_digits) fail("a number of at most 2500 digits");
    return make_number(Rational(Integer(take())), start);
  }
  fail("a number, `(`, or a name that the lines above give to a value");
}

int StatementLine::exponent() {
  const bool short_number = !at_end() && peek().size() <= 2 && std::all_of(peek().begin(), peek().end(), is_digit);
  const int value = short_number && peek().front() != '0' ? std::stoi(std::string(peek())) : 0;
  if (value < 1 || value > 64) fail("an exponent from 1 to 64");
  ++next_;
  return value;
}

std::vector<Expression> joined_parts(const Expression& formula) {
  const bool joined = formula->operation == Operation::logical_and || formula->operation == Operation::logical_or;
  return joined ? formula->operands : std::vector{formula};
}

}  // namespace slipproof
