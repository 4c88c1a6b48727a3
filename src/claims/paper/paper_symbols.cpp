#include "claims/paper/paper_symbols.hpp"

#include <algorithm>

namespace slipproof {

namespace {

/// 1 + t^2
Expression one_and_square(const Expression& t) {
  return make(Operation::add, {make_number(1), make_power(t, 2)});
}

}  // namespace

bool Parameter::is_positive() const {
  if (domain->operation != Operation::compare || domain->relations.size() != 1) return false;
  const bool greater = domain->relations[0] == Relation::greater, less = domain->relations[0] == Relation::less;
  const Expression &large = domain->operands[greater ? 0 : 1], &small = domain->operands[greater ? 1 : 0];
  return (greater || less) && is_symbol(large, symbol) && small->operation == Operation::number && small->number == 0;
}

bool Definition::is_nowhere(Reading reading) const {
  const Expression& e = value(reading);
  return e->operation == Operation::divide && e->operands[1]->operation == Operation::number &&
         e->operands[1]->number == 0;
}

std::string id(const Definition& definition) {
  return (definition.equation.empty() ? "" : definition.equation + ".") + definition.symbol;
}

Expression PaperAngle::cosine_value() const {
  const Expression t = make_symbol(name);
  return make(Operation::divide, {make(Operation::subtract, {make_number(1), make_power(t, 2)}), one_and_square(t)});
}

Expression PaperAngle::sine_value() const {
  const Expression t = make_symbol(name);
  return make(Operation::divide, {make(Operation::multiply, {make_number(2), t}), one_and_square(t)});
}

std::size_t PaperSymbols::parameter_index(std::string_view symbol) const {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.symbol == symbol; });
  return static_cast<std::size_t>(found - parameters.begin());
}

}  // namespace slipproof
