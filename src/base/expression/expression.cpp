#include "base/expression/expression.hpp"

#include <algorithm>
#include <utility>

namespace slipproof {

std::string_view spelling(Relation relation) {
  switch (relation) {
    case Relation::less:
      return "<";
    case Relation::less_equal:
      return "<=";
    case Relation::greater:
      return ">";
    case Relation::greater_equal:
      return ">=";
    case Relation::equal:
      return "=";
    case Relation::not_equal:
      return "!=";
  }
  return {};
}

bool holds(Relation relation, int sign_of_difference) {
  switch (relation) {
    case Relation::less:
      return sign_of_difference < 0;
    case Relation::less_equal:
      return sign_of_difference <= 0;
    case Relation::greater:
      return sign_of_difference > 0;
    case Relation::greater_equal:
      return sign_of_difference >= 0;
    case Relation::equal:
      return sign_of_difference == 0;
    case Relation::not_equal:
      return sign_of_difference != 0;
  }
  return false;
}

Sort sort(const Node& node) {
  return node.operation < Operation::truth ? Sort::number : Sort::truth;
}

namespace {

Expression finish(Node node) {
  for (const Expression& operand : node.operands) node.depth = std::max(node.depth, operand->depth + 1);
  return std::make_shared<const Node>(std::move(node));
}

}  // namespace

Expression make(Operation operation, std::vector<Expression> operands, std::size_t column) {
  Node node;
  node.operation = operation;
  node.operands = std::move(operands);
  node.column = column;
  return finish(std::move(node));
}

Expression make_number(Rational value, std::size_t column) {
  const bool negative = sign(value) < 0;
  Node node;
  node.operation = Operation::number;
  node.number = negative ? Rational(-value) : std::move(value);
  node.column = column;
  Expression literal = finish(std::move(node));
  return negative ? make(Operation::negate, {std::move(literal)}, column) : literal;
}

Expression make_symbol(std::string name, std::size_t column) {
  Node node;
  node.operation = Operation::symbol;
  node.symbol = std::move(name);
  node.column = column;
  return finish(std::move(node));
}

Expression make_truth(bool value, std::size_t column) {
  Node node;
  node.operation = Operation::truth;
  node.truth = value;
  node.column = column;
  return finish(std::move(node));
}

Expression make_power(Expression base, int exponent, std::size_t column) {
  Node node;
  node.operation = Operation::power;
  node.operands = {std::move(base)};
  node.exponent = exponent;
  node.column = column;
  return finish(std::move(node));
}

Expression make_comparison(std::vector<Expression> operands, std::vector<Relation> relations, std::size_t column) {
  Node node;
  node.operation = Operation::compare;
  node.operands = std::move(operands);
  node.relations = std::move(relations);
  node.column = column;
  return finish(std::move(node));
}

bool same(const Expression& a, const Expression& b) {
  if (a == b) return true;
  return a->operation == b->operation && a->depth == b->depth && a->exponent == b->exponent && a->truth == b->truth &&
         a->symbol == b->symbol && a->relations == b->relations && a->number == b->number &&
         std::equal(a->operands.begin(), a->operands.end(), b->operands.begin(), b->operands.end(), same);
}

namespace {

void collect(const Expression& expression, std::vector<std::string>& names) {
  if (expression->operation == Operation::symbol &&
      std::find(names.begin(), names.end(), expression->symbol) == names.end()) {
    names.push_back(expression->symbol);
  }
  for (const Expression& operand : expression->operands) collect(operand, names);
}

}  // namespace

bool is_symbol(const Expression& expression, std::string_view name) {
  return expression->operation == Operation::symbol && expression->symbol == name;
}

std::vector<std::string> symbols(const Expression& expression) {
  std::vector<std::string> names;
  collect(expression, names);
  return names;
}

Expression substitute(const Expression& expression, const std::function<Expression(const std::string&)>& meaning) {
  if (expression->operation == Operation::symbol) {
    Expression by = meaning(expression->symbol);
    return by ? by : expression;
  }
  bool changed = false;
  Node node = *expression;
  node.depth = 1;
  for (Expression& operand : node.operands) {
    Expression replaced = substitute(operand, meaning);
    changed = changed || replaced != operand;
    operand = std::move(replaced);
  }
  return changed ? finish(std::move(node)) : expression;
}

Expression substitute(const Expression& expression, std::string_view symbol, const Expression& by) {
  return substitute(expression, [&](const std::string& name) { return name == symbol ? by : nullptr; });
}

Binding binding(Operation operation) {
  switch (operation) {
    case Operation::logical_or:
      return Binding::disjunction;
    case Operation::logical_and:
      return Binding::conjunction;
    case Operation::logical_not:
      return Binding::negation;
    case Operation::compare:
      return Binding::comparison;
    case Operation::add:
    case Operation::subtract:
      return Binding::sum;
    case Operation::multiply:
    case Operation::divide:
      return Binding::product;
    case Operation::negate:
    case Operation::power:
      return Binding::unary;
    default:
      return Binding::primary;
  }
}

Binding tighter(Binding binding) {
  return static_cast<Binding>(static_cast<int>(binding) + 1);
}

bool is_linear_in(const Expression& e, const std::string& symbol) {
  const auto free = [&](const Expression& x) {
    const auto names = symbols(x);
    return std::find(names.begin(), names.end(), symbol) == names.end();
  };
  if (free(e)) return true;
  const auto linear = [&](const Expression& x) { return is_linear_in(x, symbol); };
  switch (e->operation) {
    case Operation::symbol:
    case Operation::negate:
    case Operation::add:
    case Operation::subtract:
      return std::all_of(e->operands.begin(), e->operands.end(), linear);
    case Operation::multiply:
      return (free(e->operands[0]) && linear(e->operands[1])) || (linear(e->operands[0]) && free(e->operands[1]));
    case Operation::divide:
      return linear(e->operands[0]) && free(e->operands[1]);
    default:
      return false;
  }
}

}  // namespace slipproof
