#include "verify/same_function.hpp"

#include <algorithm>

namespace slipproof {

namespace {

/// Every symbol that is no definition is a variable.
SymbolicEvaluator all_symbols(const Scope& scope) {
  const auto count = std::count_if(scope.slots.begin(), scope.slots.end(), [](const auto& s) { return !s.definition; });
  auto ring = std::make_shared<PolynomialRing>(static_cast<std::size_t>(count));
  SymbolicEvaluator evaluator(scope, FractionField{ring});
  for (std::size_t i = 0, variable = 0; i < scope.slots.size(); ++i) {
    if (!scope.slots[i].definition) evaluator.set(i, Fraction(MultiPolynomial::variable(ring, variable++)));
  }
  return evaluator;
}

}  // namespace

Functions::Functions(const CompiledSetting& setting) : setting_(&setting), symbols_(all_symbols(setting.scope())) {}

std::optional<Fraction> Functions::value(const Expression& e, bool equation) {
  const auto value = symbols_.number(equation ? setting_->compile_equation(e, Reading::printed)
                                              : setting_->compile(e, Reading::printed));
  return value.number ? std::optional(value.number->value()) : std::nullopt;
}

bool Functions::same(const Expression& x, const Expression& y, bool equation) {
  if (slipproof::same(x, y)) return true;
  if (sort(*x) == Sort::number) {
    const auto a = value(x, equation), b = value(y, equation);
    return a && b && (*a - *b).numerator.is_zero();
  }
  if (x->operation != y->operation || x->relations != y->relations || x->operands.size() != y->operands.size()) {
    return false;
  }
  if (x->operation == Operation::truth) return x->truth == y->truth;
  return std::equal(x->operands.begin(), x->operands.end(), y->operands.begin(),
                    [&](const Expression& a, const Expression& b) { return same(a, b, equation); });
}

}  // namespace slipproof
