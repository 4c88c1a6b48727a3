// Expressions back to text.
#include <string>

#include "base/expression/expression.hpp"

namespace slipproof {

namespace {

// A finite decimal reads back as the same literal; other values become a quotient in parentheses.
std::string literal(const Rational& value) {
  constexpr unsigned longest = 1'000;
  const Integer &dividend = numerator(value), &divisor = denominator(value);
  if (divisor == 1) return dividend.str();
  unsigned digits = 0;
  Integer scaled = dividend, rest = divisor;
  while (rest != 1) {
    const Integer factor = gcd(rest, Integer(10));
    if (factor == 1 || digits == longest) return "(" + dividend.str() + " / " + divisor.str() + ")";
    scaled *= 10 / factor;
    rest /= factor;
    ++digits;
  }
  std::string text = scaled.str();
  if (text.size() <= digits) text.insert(0, digits + 1 - text.size(), '0');
  return text.insert(text.size() - digits, 1, '.');
}

void print(const Expression& expression, Binding at_least, std::string& text);

void print_infix(const Node& node, std::string_view sign, Binding right, std::string& text) {
  print(node.operands[0], binding(node.operation), text);
  text += ' ';
  text += sign;
  text += ' ';
  print(node.operands[1], right, text);
}

void print_call(const Node& node, std::string_view function, std::string& text) {
  text += function;
  for (std::size_t i = 0; i < node.operands.size(); ++i) {
    text += i == 0 ? "(" : ", ";
    print(node.operands[i], Binding::loosest, text);
  }
  text += ')';
}

void print_bare(const Node& node, std::string& text) {
  switch (node.operation) {
    case Operation::number:
      text += literal(node.number);
      break;
    case Operation::symbol:
      text += node.symbol;
      break;
    case Operation::truth:
      text += node.truth ? "true" : "false";
      break;
    case Operation::negate:
      text += '-';
      print(node.operands[0], Binding::unary, text);
      break;
    case Operation::add:
      print_infix(node, "+", Binding::product, text);
      break;
    case Operation::subtract:
      print_infix(node, "-", Binding::product, text);
      break;
    case Operation::multiply:
      print_infix(node, "*", Binding::unary, text);
      break;
    case Operation::divide:
      print_infix(node, "/", Binding::unary, text);
      break;
    case Operation::power:
      print(node.operands[0], Binding::primary, text);
      text += '^' + std::to_string(node.exponent);
      break;
    case Operation::absolute:
      print_call(node, "abs", text);
      break;
    case Operation::signum:
      print_call(node, "sign", text);
      break;
    case Operation::minimum:
      print_call(node, "min", text);
      break;
    case Operation::maximum:
      print_call(node, "max", text);
      break;
    case Operation::compare:
      for (std::size_t i = 0; i < node.operands.size(); ++i) {
        if (i != 0) text.append(" ").append(spelling(node.relations[i - 1])).append(" ");
        print(node.operands[i], Binding::sum, text);
      }
      break;
    case Operation::logical_not:
      text += "not ";
      print(node.operands[0], Binding::negation, text);
      break;
    case Operation::logical_and:
      print_infix(node, "and", Binding::negation, text);
      break;
    case Operation::logical_or:
      print_infix(node, "or", Binding::conjunction, text);
      break;
  }
}

void print(const Expression& expression, Binding at_least, std::string& text) {
  const bool parentheses = binding(expression->operation) < at_least;
  if (parentheses) text += '(';
  print_bare(*expression, text);
  if (parentheses) text += ')';
}

}  // namespace

std::string to_string(const Expression& expression) {
  std::string text;
  print(expression, Binding::loosest, text);
  return text;
}

}  // namespace slipproof
