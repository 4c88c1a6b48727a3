#include "mechanics/mechanism/algebra.hpp"

#include <algorithm>
#include <optional>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

namespace {

bool is_negation(const Expression& x) {
  return x->operation == Operation::negate;
}

/// Whether it begins with a minus: -b * N1.
bool is_negative(const Expression& x) {
  const bool product = x->operation == Operation::multiply || x->operation == Operation::divide;
  return is_negation(x) || (product && is_negative(x->operands[0]));
}

/// The value of a literal, also of a negated one.
std::optional<Rational> literal(const Expression& x) {
  if (x->operation == Operation::number) return x->number;
  if (is_negation(x) && x->operands[0]->operation == Operation::number) return Rational(-x->operands[0]->number);
  return std::nullopt;
}

bool is_literal(const Expression& x, int value) {
  const auto number = literal(x);
  return number && *number == value;
}

}  // namespace

Expression zero_literal() {
  static const Expression zero = make_number(0);
  return zero;
}

Expression negative_of(const Expression& x) {
  if (const auto value = literal(x)) return make_number(Rational(-*value));
  if (is_negation(x)) return x->operands[0];
  if (x->operation == Operation::multiply || x->operation == Operation::divide) {
    return make(x->operation, {negative_of(x->operands[0]), x->operands[1]});
  }
  if (x->operation == Operation::subtract) {
    const Expression &from = x->operands[0], &taken = x->operands[1];
    if (is_negative(from)) return make(Operation::add, {taken, negative_of(from)});
    return make(Operation::subtract, {taken, from});
  }
  return make(Operation::negate, {x});
}

Expression sum_of(const Expression& x, const Expression& y, const OfExpression& defined) {
  const auto a = literal(x), b = literal(y);
  if (a && b) return make_number(Rational(*a + *b));
  if (a && a->is_zero()) return y;
  if (b && b->is_zero()) return x;
  if (is_negative(y)) return difference_of(x, negative_of(y), defined);
  return make(Operation::add, {x, y});
}

Expression appended(const Expression& x, const Expression& y) {
  if (y->operation == Operation::add) return sum_of(appended(x, y->operands[0]), y->operands[1]);
  if (y->operation == Operation::subtract) return difference_of(appended(x, y->operands[0]), y->operands[1]);
  return sum_of(x, y);
}

Expression difference_of(const Expression& x, const Expression& y, const OfExpression& defined) {
  const auto a = literal(x), b = literal(y);
  if (a && b) return make_number(Rational(*a - *b));
  if (a && a->is_zero()) return negative_of(y);
  if (b && b->is_zero()) return x;
  if (same(x, y) && defined(x)) return zero_literal();
  if (is_negative(y)) return sum_of(x, negative_of(y), defined);
  return make(Operation::subtract, {x, y});
}

Expression product_of(const Expression& x, const Expression& y, const OfExpression& defined) {
  const auto a = literal(x), b = literal(y);
  if (a && b) return make_number(Rational(*a * *b));
  if ((a && a->is_zero() && defined(y)) || (b && b->is_zero() && defined(x))) return zero_literal();
  if (is_literal(x, 1)) return y;
  if (is_literal(y, 1)) return x;
  if (is_literal(x, -1)) return negative_of(y);
  if (is_literal(y, -1)) return negative_of(x);
  if (is_negation(x)) return negative_of(product_of(x->operands[0], y, defined));
  if (is_negation(y)) return negative_of(product_of(x, y->operands[0], defined));
  return make(Operation::multiply, {x, y});
}

Expression quotient_of(const Expression& x, const Expression& y) {
  if (is_literal(y, 1)) return x;
  if (is_negation(x)) return negative_of(quotient_of(x->operands[0], y));
  return make(Operation::divide, {x, y});
}

Expression folded(const Expression& x) {
  if (x->operands.empty()) return x;
  Node node = *x;
  for (Expression& operand : node.operands) operand = folded(operand);
  const auto first = literal(node.operands[0]), second = literal(node.operands.back());
  if (first && second) {
    switch (node.operation) {
      case Operation::add:
        return make_number(Rational(*first + *second));
      case Operation::subtract:
        return make_number(Rational(*first - *second));
      case Operation::multiply:
        return make_number(Rational(*first * *second));
      case Operation::divide:
        if (!second->is_zero()) return make_number(Rational(*first / *second));
        break;
      default:
        break;
    }
  }
  return std::make_shared<const Node>(std::move(node));
}

Expression derivative_of(const Expression& x, std::string_view symbol) {
  const auto of = [&](std::size_t operand) { return derivative_of(x->operands[operand], symbol); };
  switch (x->operation) {
    case Operation::symbol:
      return make_number(x->symbol == symbol ? 1 : 0);
    case Operation::negate:
      return negative_of(of(0));
    case Operation::add:
      return sum_of(of(0), of(1));
    case Operation::subtract:
      return difference_of(of(0), of(1));
    case Operation::multiply:
      return sum_of(product_of(of(0), x->operands[1]), product_of(x->operands[0], of(1)));
    case Operation::power: {
      const Expression& base = x->operands[0];
      const Expression inner = of(0);
      if (is_literal_zero(inner) || x->exponent == 0) return zero_literal();
      const Expression lower = x->exponent == 2 ? base : make_power(base, x->exponent - 1, x->column);
      return product_of(product_of(make_number(x->exponent), lower), inner);
    }
    default:
      break;
  }
  const auto inside = symbols(x);
  const bool depends = std::find(inside.begin(), inside.end(), symbol) != inside.end();
  if (!depends) return zero_literal();
  return x->operation == Operation::divide ? quotient_of(of(0), x->operands[1]) : x;
}

}  // namespace slipproof
