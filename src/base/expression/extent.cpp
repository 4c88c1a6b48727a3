#include "base/expression/extent.hpp"

#include <algorithm>
#include <cstdlib>

namespace slipproof {

namespace {

double literal_terms(const Rational& value) {
  constexpr std::size_t bits_of_term = 64;
  if (value.is_zero()) return 1;
  return 1.0 + static_cast<double>((numerator(value).bits() + denominator(value).bits() - 2) / bits_of_term);
}

}  // namespace

Extent extent(const Expression& expression, const ExtentOfDefinition& of_definition) {
  Extent total{0, 1};
  for (const Expression& operand : expression->operands) {
    const Extent part = extent(operand, of_definition);
    total.terms += part.terms;
    total.depth = std::max(total.depth, part.depth + 1);
  }
  if (expression->operation == Operation::power) total.terms *= std::max(1, std::abs(expression->exponent));
  if (expression->operation == Operation::number) total.terms = literal_terms(expression->number);
  if (expression->operation == Operation::symbol) {
    const auto definition = of_definition(expression->symbol);
    return definition ? Extent{definition->terms, definition->depth + 1} : Extent{};
  }
  return total;
}

std::string too_large(const Extent& extent) {
  constexpr double max_terms = 10'000;
  constexpr std::size_t max_depth = 1'000;
  if (extent.terms > max_terms) {
    return "too large to evaluate: more than 10000 terms with all definitions written out";
  }
  if (extent.depth > max_depth) {
    return "nested more than 1000 levels deep with all definitions written out";
  }
  return {};
}

}  // namespace slipproof
