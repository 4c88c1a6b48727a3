#include "claims/identity/same_function.hpp"

#include <algorithm>

namespace slipproof {

namespace {

/// The symbols that are not definitions; each is a variable.
std::vector<std::size_t> given_symbols(const Scope& scope) {
  std::vector<std::size_t> slots;
  for (std::size_t i = 0; i < scope.slots.size(); ++i) {
    if (!scope.slots[i].definition) slots.push_back(i);
  }
  return slots;
}

}  // namespace

Functions::Functions(const CompiledSetting& setting)
    : setting_(&setting),
      ring_(ring_of(setting.scope(), given_symbols(setting.scope()))),
      symbols_(symbolic(setting.scope(), given_symbols(setting.scope()), *ring_)) {}

std::optional<ReducedFraction> Functions::value(const Expression& e) {
  const auto value = symbols_.number(setting_->compile(e, Reading::printed));
  return value.number ? std::optional(value.number->value()) : std::nullopt;
}

bool Functions::same(const Expression& x, const Expression& y) {
  if (slipproof::same(x, y)) return true;
  if (sort(*x) == Sort::number) {
    const auto a = value(x), b = value(y);
    return a && b && (*a - *b).numerator.is_zero();
  }
  if (x->operation != y->operation || x->relations != y->relations || x->operands.size() != y->operands.size()) {
    return false;
  }
  if (x->operation == Operation::truth) return x->truth == y->truth;
  return std::equal(x->operands.begin(), x->operands.end(), y->operands.begin(),
                    [&](const Expression& a, const Expression& b) { return same(a, b); });
}

}  // namespace slipproof
