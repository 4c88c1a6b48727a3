#include "mechanics/family/family.hpp"

#include <algorithm>
#include <set>

#include "base/expression/cases.hpp"
#include "base/expression/logic.hpp"
#include "mechanics/mechanism/coefficients.hpp"

namespace slipproof {

namespace {

Expression square(const Expression& x) {
  return make_power(x, 2);
}

/// 1 + t^2
Expression one_and_square(const Expression& t) {
  return make(Operation::add, {make_number(1), square(t)});
}

const MechanismDefinition* definition_of(const Mechanism& mechanism, std::string_view symbol) {
  const auto found = std::ranges::find(mechanism.definitions, symbol, &MechanismDefinition::symbol);
  return found == mechanism.definitions.end() ? nullptr : &*found;
}

/// The divisors in the coefficients of its mechanism, each once, without nonzero numbers.
std::vector<Expression> divisors_of_coefficients(const Family& family) {
  std::vector<Expression> result;
  std::set<std::string> known;
  for (const Expression& coefficient : coefficients(*family.mechanism)) {
    for (const Expression& divisor : divisors(family.in_family(coefficient))) {
      const bool plain = divisor->operation == Operation::number && !divisor->number.is_zero();
      if (!plain && known.insert(to_string(divisor)).second) result.push_back(divisor);
    }
  }
  return result;
}

}  // namespace

bool FreeParameter::is_positive() const {
  if (domain->operation != Operation::compare || domain->relations.size() != 1) return false;
  const bool greater = domain->relations[0] == Relation::greater, less = domain->relations[0] == Relation::less;
  const Expression &large = domain->operands[greater ? 0 : 1], &small = domain->operands[greater ? 1 : 0];
  return (greater || less) && is_symbol(large, symbol) && small->operation == Operation::number && small->number == 0;
}

Expression FreeAngle::cosine_value() const {
  const Expression t = make_symbol(name);
  return make(Operation::divide, {make(Operation::subtract, {make_number(1), square(t)}), one_and_square(t)});
}

Expression FreeAngle::sine_value() const {
  const Expression t = make_symbol(name);
  return make(Operation::divide, {make(Operation::multiply, {make_number(2), t}), one_and_square(t)});
}

std::size_t Family::parameter_index(std::string_view symbol) const {
  return static_cast<std::size_t>(std::ranges::find(parameters, symbol, &FreeParameter::symbol) - parameters.begin());
}

Expression Family::in_family(const Expression& of_mechanism) const {
  return substitute(of_mechanism, [this](const std::string& symbol) -> Expression {
    if (const auto found = scene.find(symbol); found != scene.end()) return found->second;
    if (const MechanismDefinition* definition = definition_of(*mechanism, symbol)) {
      return in_family(definition->expression.expression);
    }
    const auto& all = mechanism->parameters;
    // A parameter that is not given counts as 0.
    const bool is_parameter = std::ranges::find(all, symbol, &MechanismParameter::symbol) != all.end();
    return is_parameter ? make_number(0) : nullptr;
  });
}

void Family::restrict_force_to_load() {
  if (!mechanism->load) return;
  for (const PlacedExpression& bound : mechanism->load->domain) {
    force.domain = conjunction(force.domain, in_family(bound.expression));
  }
}

std::vector<bool> Family::given() const {
  std::vector<bool> result;
  for (const MechanismParameter& parameter : mechanism->parameters) result.push_back(scene.contains(parameter.symbol));
  return result;
}

std::vector<ElementKind> Family::kinds() const {
  return element_kinds(*mechanism, starts, given());
}

std::vector<ElementKind> Family::all_kinds() const {
  auto kinds = element_kinds(*mechanism, starts, std::vector<bool>(mechanism->parameters.size(), true));
  for (ElementKind& kind : kinds) kind.slips = true;
  return kinds;
}

std::vector<std::string> Family::quantities() const {
  std::vector<std::string> names = acceleration_names(*mechanism);
  for (std::string& force : force_names(*mechanism)) names.push_back(std::move(force));
  return names;
}

std::optional<std::size_t> Family::unknown_index(std::string_view symbol) const {
  const auto& unknowns = mechanism->unknowns;
  const auto found = std::ranges::find(unknowns, symbol, &MechanismUnknown::symbol);
  return found == unknowns.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - unknowns.begin()));
}

Family::PointConditions Family::point_conditions() const {
  PointConditions result;
  const auto add = [&](const PlacedExpression& condition) {
    if (condition) result.truths.push_back(in_family(condition.expression));
  };
  for (const MechanismParameter& parameter : mechanism->parameters) {
    const auto value = scene.find(parameter.symbol);
    if (value == scene.end()) continue;
    add(parameter.domain);
    result.defined.push_back(value->second);
  }
  for (const MechanismAngle& angle : mechanism->angles) {
    const Expression &c = scene.find(angle.cosine)->second, &s = scene.find(angle.sine)->second;
    const bool is_free = std::any_of(angles.begin(), angles.end(), [&](const FreeAngle& own) {
      return is_symbol(c, own.cosine) && is_symbol(s, own.sine);
    });
    add(angle.domain);
    result.defined.insert(result.defined.end(), {c, s});
    if (is_free) continue;
    const Expression sum = make(Operation::add, {square(c), square(s)});
    result.truths.push_back(make_comparison({sum, make_number(1)}, {Relation::equal}));
  }
  for (const MechanismCondition& condition : mechanism->assume) add(condition.condition);
  for (const Expression& divisor : divisors_of_coefficients(*this)) {
    result.truths.push_back(make_comparison({divisor, make_number(0)}, {Relation::not_equal}));
  }
  if (!mechanism->load) return result;
  const Expression& load = scene.find(mechanism->load->symbol)->second;
  const auto at = [&](int x) { return substitute(load, force.symbol, make_number(x)); };
  if (is_linear_in(load, force.symbol)) result.slope = make(Operation::subtract, {at(1), at(0)});
  return result;
}

}  // namespace slipproof
