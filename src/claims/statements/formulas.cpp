#include "claims/statements/formulas.hpp"

#include <vector>

#include "base/expression/logic.hpp"

namespace slipproof {

namespace {

/// Writes powers in the syntax of statements: exponents from 1.
Expression written(const Expression& e, const OfExpression& defined) {
  if (e->operation == Operation::power && e->exponent < 1) {
    const Expression base = written(e->operands[0], defined), one = make_number(1);
    if (e->exponent < 0)
      return make(Operation::divide, {one, e->exponent == -1 ? base : make_power(base, -e->exponent)});
    if (defined(e->operands[0])) return one;
    // 0 * base + 1 is 1 where the base has a value, and has none elsewhere.
    return make(Operation::add, {make(Operation::multiply, {make_number(0), base}), one});
  }
  if (e->operands.empty()) return e;
  std::vector<Expression> operands;
  for (const Expression& operand : e->operands) operands.push_back(written(operand, defined));
  if (e->operation == Operation::power) return make_power(operands[0], e->exponent);
  if (e->operation == Operation::compare) return make_comparison(std::move(operands), e->relations);
  return make(e->operation, std::move(operands));
}

/// The formula of a condition without functions.
Expression formula(const Expression& e, const OfExpression& defined) {
  if (e->operation == Operation::truth) return e->truth ? plainly_true() : e;
  if (e->operation == Operation::logical_not) return formula(opposite(e->operands[0]), defined);
  if (e->operation == Operation::compare) return written(with_quotients(e), defined);
  const Expression left = formula(e->operands[0], defined), right = formula(e->operands[1], defined);
  std::vector<Expression> parts = left->operation == e->operation ? left->operands : std::vector{left};
  parts.push_back(right);
  return make(e->operation, std::move(parts));
}

}  // namespace

Expression with_quotients(const Expression& e) {
  if (e->operation == Operation::number && denominator(e->number) != 1) {
    return make(Operation::divide,
                {make_number(Rational(numerator(e->number))), make_number(Rational(denominator(e->number)))});
  }
  if (e->operands.empty()) return e;
  std::vector<Expression> operands;
  for (const Expression& operand : e->operands) operands.push_back(with_quotients(operand));
  if (e->operation == Operation::power) return make_power(operands[0], e->exponent);
  if (e->operation == Operation::compare) return make_comparison(std::move(operands), e->relations);
  return make(e->operation, std::move(operands));
}

Expression plainly_true() {
  return make_comparison({make_number(0), make_number(0)}, {Relation::equal});
}

Expression formula_of(const Expression& truth, const OfExpression& defined) {
  const Expression plain = by_cases(truth, is_function, defined);
  return plain ? formula(plain, defined) : nullptr;
}

Expression written_number(const Expression& number, const OfExpression& defined) {
  return has_function(number) ? nullptr : written(with_quotients(number), defined);
}

std::string in_ascii(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
    if (!continues) result += c < ' ' || c > '~' ? '?' : c;
  }
  return result;
}

}  // namespace slipproof
