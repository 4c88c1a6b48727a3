#include "mechanics/mechanism/extraction.hpp"

#include <algorithm>

#include "mechanics/mechanism/algebra.hpp"

namespace slipproof::mechanism_forms {

Extraction::Extraction(const Mechanism& mechanism)
    : mechanism_(mechanism),
      names_(mechanism),
      defined_([this](const Expression& e) { return divides_by_nothing(e); }) {
  loaded_.assign(mechanism.definitions.size(), false);
  if (mechanism.load) loaded_ = definitions_with(mechanism, names_, mechanism.load->symbol);
  dividing_.assign(mechanism.definitions.size(), false);
  for (std::size_t i = 0; i < dividing_.size(); ++i) {  // a definition uses only those before it
    const Expression& value = mechanism.definitions[i].expression.expression;
    dividing_[i] = value && !divides_by_nothing(value);
  }
}

bool Extraction::uses(const Expression& expression, const std::vector<bool>& definitions) const {
  const auto used = symbols(expression);
  return std::any_of(used.begin(), used.end(), [&](const std::string& symbol) {
    const auto entry = names_.find(symbol);
    return entry && entry->kind == NameKind::definition && definitions[entry->index];
  });
}

bool Extraction::divides_by_nothing(const Expression& expression) const {
  return has_no_division(expression) && !uses(expression, dividing_);
}

bool Extraction::has_load(const Expression& expression) const {
  const auto used = symbols(expression);
  return uses(expression, loaded_) || std::any_of(used.begin(), used.end(), [&](const std::string& symbol) {
           const auto entry = names_.find(symbol);
           return entry && entry->kind == NameKind::load;
         });
}

Linear Extraction::scaled(const Linear& linear, const Expression& factor, bool factor_first) const {
  const auto times = [&](const Expression& x) {
    return factor_first ? product_of(factor, x, defined_) : product_of(x, factor, defined_);
  };
  Linear result{times(linear.constant), {}};
  for (const auto& [variable, coefficient] : linear.terms) {
    const Expression product = times(coefficient);
    if (!is_literal_zero(product)) result.terms.emplace(variable, product);
  }
  return result;
}

std::string Extraction::variable(const Linear& linear) const {
  const std::size_t index = linear.terms.begin()->first;
  if (index == mechanism_.unknowns.size()) return "the load " + mechanism_.load->symbol;
  return "the unknown " + mechanism_.unknowns[index].symbol;
}

Linear Extraction::symbol(const Expression& expression) const {
  const auto entry = names_.find(expression->symbol);
  const Expression one = make_number(1);
  if (entry && (entry->kind == NameKind::acceleration || entry->kind == NameKind::force ||
                entry->kind == NameKind::element_force)) {
    return {zero_literal(), {{entry->index, one}}};
  }
  if (entry && entry->kind == NameKind::load) return {zero_literal(), {{mechanism_.unknowns.size(), one}}};
  if (entry && entry->kind == NameKind::definition && loaded_[entry->index]) {
    const Expression& definition = mechanism_.definitions[entry->index].expression.expression;
    try {
      return linear(definition);
    } catch (const NotLinear& error) {
      throw NotLinear{expression, error.message};
    }
  }
  return {expression, {}};
}

Linear Extraction::sum(const Expression& expression) const {
  Linear left = linear(expression->operands[0]);
  const Linear right = linear(expression->operands[1]);
  const bool minus = expression->operation == Operation::subtract;
  const auto combined = [&](const Expression& x, const Expression& y) {
    return minus ? difference_of(x, y, defined_) : sum_of(x, y, defined_);
  };
  left.constant = combined(left.constant, right.constant);
  for (const auto& [variable, coefficient] : right.terms) {
    Expression& mine = left.terms.try_emplace(variable, zero_literal()).first->second;
    mine = combined(mine, coefficient);
    if (is_literal_zero(mine)) left.terms.erase(variable);
  }
  return left;
}

Linear Extraction::product(const Expression& expression) const {
  const Linear left = linear(expression->operands[0]), right = linear(expression->operands[1]);
  const bool divides = expression->operation == Operation::divide;
  if (!right.terms.empty() && (divides || !left.terms.empty())) {
    const std::string verb = divides ? " divides" : " multiplies " + variable(left);
    throw NotLinear{expression, "not linear: " + in_quotes(to_string(expression)) + verb + " by " + variable(right)};
  }
  if (!divides) return left.terms.empty() ? scaled(right, left.constant, true) : scaled(left, right.constant, false);
  Linear result{quotient_of(left.constant, right.constant), {}};
  for (const auto& [variable, coefficient] : left.terms) {
    result.terms.emplace(variable, quotient_of(coefficient, right.constant));
  }
  return result;
}

Linear Extraction::linear(const Expression& expression) const {
  switch (expression->operation) {
    case Operation::number:
      return {expression, {}};
    case Operation::symbol:
      return symbol(expression);
    case Operation::negate: {
      const Linear operand = linear(expression->operands[0]);
      Linear result{negative_of(operand.constant), {}};
      for (const auto& [variable, coefficient] : operand.terms) {
        result.terms.emplace(variable, negative_of(coefficient));
      }
      return result;
    }
    case Operation::add:
    case Operation::subtract:
      return sum(expression);
    case Operation::multiply:
    case Operation::divide:
      return product(expression);
    default:
      break;
  }
  for (const Expression& operand : expression->operands) {
    const Linear inside = linear(operand);
    if (inside.terms.empty()) continue;
    if (expression->operation == Operation::power && expression->exponent == 1) return inside;
    const std::string what = expression->operation == Operation::power ? " is a power of " : " is a function of ";
    throw NotLinear{expression, "not linear: " + in_quotes(to_string(expression)) + what + variable(inside)};
  }
  return {expression, {}};
}

SymbolicForm Extraction::form(const Linear& linear) const {
  SymbolicForm form{{}, zero_literal(), linear.constant};
  for (const auto& [variable, coefficient] : linear.terms) {
    if (variable == mechanism_.unknowns.size()) {
      form.load = coefficient;
    } else if (!is_literal_zero(coefficient)) {
      form.terms.emplace_back(variable, coefficient);
    }
  }
  return form;
}

SymbolicForm Extraction::form(const Expression& expression) const {
  return form(linear(expression));
}

}  // namespace slipproof::mechanism_forms
