#include "mechanics/bodies/identity.hpp"

#include "base/expression/parser.hpp"
#include "mechanics/bodies/quotients.hpp"
#include "mechanics/bodies/sure_sign.hpp"
#include "mechanics/mechanism/algebra.hpp"

namespace slipproof::bodies_in_motion {

namespace {

/// The number of literals, symbols and operations.
std::size_t size(const Expression& expression) {
  std::size_t sum = 1;
  for (const Expression& operand : expression->operands) sum += size(operand);
  return sum;
}

}  // namespace

bool vanishes_identically(const Mechanism& mechanism, const Expression& expression) {
  if (is_literal_zero(expression)) return true;
  try {
    Quotients quotients(mechanism);
    const Quotient value = quotients.of(expression);
    return value.over.is_zero() && !value.under.is_zero();
  } catch (const NoQuotient&) {
  } catch (const Budget::Spent&) {
  }
  return false;
}

std::optional<Expression> root_of_square(const Mechanism& mechanism, const Expression& square) {
  try {
    Quotients quotients(mechanism);
    const auto root = quotients.root(quotients.of(square));
    if (!root) return std::nullopt;
    const Expression value = quotient_of(read_back(root->over), read_back(root->under));
    const Signs signs = sure_signs(mechanism, value);
    return !signs.negative ? value : !signs.positive ? negative_of(value) : make(Operation::absolute, {value});
  } catch (const NoQuotient&) {
  } catch (const Budget::Spent&) {
  } catch (const ExpressionError&) {  // too long for people
  }
  return std::nullopt;
}

Expression shortened(const Mechanism& mechanism, const Expression& expression) {
  if (expression->operands.empty()) return expression;
  try {
    Quotients quotients(mechanism);
    const Quotient value = quotients.of(expression);
    if (value.under.is_zero()) return expression;
    const Expression shorter = quotients.expression(value);
    if (size(shorter) < size(expression)) return shorter;
  } catch (const NoQuotient&) {
  } catch (const Budget::Spent&) {
  } catch (const ExpressionError&) {  // too long for people
  }
  return expression;
}

}  // namespace slipproof::bodies_in_motion
