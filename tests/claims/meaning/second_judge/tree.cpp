#include "claims/meaning/second_judge/tree.hpp"

#include <stdexcept>

namespace slipproof::meaning {

namespace {

std::string spelling(Op op) {
  switch (op) {
    case Op::add:
      return " + ";
    case Op::subtract:
      return " - ";
    case Op::multiply:
      return "*";
    case Op::divide:
      return "/";
    case Op::conjunction:
      return " and ";
    case Op::disjunction:
      return " or ";
    case Op::absolute:
      return "abs";
    case Op::signum:
      return "sign";
    case Op::minimum:
      return "min";
    case Op::maximum:
      return "max";
    default:
      throw std::logic_error("no spelling");
  }
}

Rational applied(Op op, const Rational& x, const Rational& y) {
  switch (op) {
    case Op::add:
      return x + y;
    case Op::subtract:
      return x - y;
    case Op::multiply:
      return x * y;
    case Op::minimum:
      return x < y ? x : y;
    case Op::maximum:
      return x < y ? y : x;
    default:
      throw std::logic_error("no operation on two numbers");
  }
}

Number of_parts(const Tree& tree, const std::vector<Rational>& parts) {
  switch (tree->op) {
    case Op::negate:
      return -parts[0];
    case Op::absolute:
      return parts[0] < 0 ? -parts[0] : parts[0];
    case Op::signum:
      return Rational(sign(parts[0]));
    case Op::power:
      return to_power(parts[0], tree->exponent);
    case Op::divide:
      return parts[1] == 0 ? Number() : Rational(parts[0] / parts[1]);
    default:
      return applied(tree->op, parts[0], parts[1]);
  }
}

std::string chain_text(const Tree& tree) {
  std::string result = text(tree->parts[0]);
  for (std::size_t i = 0; i < tree->relations.size(); ++i) {
    result += " " + tree->relations[i] + " " + text(tree->parts[i + 1]);
  }
  return "(" + result + ")";
}

/// Exact in the grammar of numbers: digits, or a quotient of two.
std::string number_text(const Rational& value) {
  return value < 0 || denominator(value) != 1 ? "(" + value.str() + ")" : value.str();
}

}  // namespace

Tree make(Op op, std::vector<Tree> parts) {
  Node node;
  node.op = op;
  node.parts = std::move(parts);
  return std::make_shared<const Node>(std::move(node));
}

Tree number(const Rational& value) {
  Node node;
  node.op = Op::number;
  node.number = value;
  return std::make_shared<const Node>(std::move(node));
}

Tree symbol(const std::string& name) {
  Node node;
  node.op = Op::symbol;
  node.symbol = name;
  return std::make_shared<const Node>(std::move(node));
}

Tree truth(bool value) {
  Node node;
  node.truth = value;
  return std::make_shared<const Node>(std::move(node));
}

Tree power(Tree base, int exponent) {
  Node node;
  node.op = Op::power;
  node.parts = {std::move(base)};
  node.exponent = exponent;
  return std::make_shared<const Node>(std::move(node));
}

Tree chain(std::vector<Tree> parts, std::vector<std::string> relations) {
  Node node;
  node.op = Op::chain;
  node.parts = std::move(parts);
  node.relations = std::move(relations);
  return std::make_shared<const Node>(std::move(node));
}

Tree compare(Tree left, const std::string& relation, Tree right) {
  return chain({std::move(left), std::move(right)}, {relation});
}

Tree plus(Tree x, Tree y) {
  return make(Op::add, {std::move(x), std::move(y)});
}

Tree minus(Tree x, Tree y) {
  return make(Op::subtract, {std::move(x), std::move(y)});
}

Tree times(Tree x, Tree y) {
  return make(Op::multiply, {std::move(x), std::move(y)});
}

Tree over(Tree x, Tree y) {
  return make(Op::divide, {std::move(x), std::move(y)});
}

std::string text(const Tree& tree) {
  switch (tree->op) {
    case Op::number:
      return number_text(tree->number);
    case Op::symbol:
      return tree->symbol;
    case Op::truth:
      return tree->truth ? "true" : "false";
    case Op::negate:
      return "(-" + text(tree->parts[0]) + ")";
    case Op::negation:
      return "(not " + text(tree->parts[0]) + ")";
    case Op::power:
      return "((" + text(tree->parts[0]) + ")^" + std::to_string(tree->exponent) + ")";
    case Op::chain:
      return chain_text(tree);
    case Op::absolute:
    case Op::signum:
      return spelling(tree->op) + "(" + text(tree->parts[0]) + ")";
    case Op::minimum:
    case Op::maximum:
      return spelling(tree->op) + "(" + text(tree->parts[0]) + ", " + text(tree->parts[1]) + ")";
    default:
      return "(" + text(tree->parts[0]) + spelling(tree->op) + text(tree->parts[1]) + ")";
  }
}

std::set<std::string> symbols(const Tree& tree) {
  if (tree->op == Op::symbol) return {tree->symbol};
  std::set<std::string> result;
  for (const Tree& part : tree->parts) result.merge(symbols(part));
  return result;
}

Number to_power(const Rational& base, int exponent) {
  if (exponent < 0 && base == 0) return {};
  Rational result = 1;
  for (int i = 0; i < std::abs(exponent); ++i) result *= base;
  return exponent < 0 ? Rational(1 / result) : result;
}

bool stands(const Rational& difference, const std::string& relation) {
  if (relation == "<") return difference < 0;
  if (relation == "<=") return difference <= 0;
  if (relation == ">") return difference > 0;
  if (relation == ">=") return difference >= 0;
  if (relation == "=") return difference == 0;
  return difference != 0;
}

Truth negation(Truth x) {
  return x ? Truth(!*x) : Truth();
}

Truth conjunction(Truth x, Truth y) {
  if (is_false(x) || is_false(y)) return false;
  return x && y ? Truth(true) : Truth();
}

Truth disjunction(Truth x, Truth y) {
  return negation(conjunction(negation(x), negation(y)));
}

Number number_of(const Tree& tree, const Names& names) {
  if (tree->op == Op::number) return tree->number;
  if (tree->op == Op::symbol) {
    const auto value = names.values.find(tree->symbol);
    return value != names.values.end() ? value->second : number_of(names.definitions.at(tree->symbol), names);
  }
  std::vector<Rational> parts;
  for (const Tree& part : tree->parts) {
    const Number value = number_of(part, names);
    if (!value) return {};
    parts.push_back(*value);
  }
  return of_parts(tree, parts);
}

Truth truth_of(const Tree& tree, const Names& names) {
  switch (tree->op) {
    case Op::truth:
      return tree->truth;
    case Op::negation:
      return negation(truth_of(tree->parts[0], names));
    case Op::conjunction:
      return conjunction(truth_of(tree->parts[0], names), truth_of(tree->parts[1], names));
    case Op::disjunction:
      return disjunction(truth_of(tree->parts[0], names), truth_of(tree->parts[1], names));
    default:
      break;
  }
  Truth result = true;
  for (std::size_t i = 0; i < tree->relations.size(); ++i) {
    const Number left = number_of(tree->parts[i], names), right = number_of(tree->parts[i + 1], names);
    const Truth link = left && right ? Truth(stands(*left - *right, tree->relations[i])) : Truth();
    result = conjunction(result, link);
  }
  return result;
}

}  // namespace slipproof::meaning
