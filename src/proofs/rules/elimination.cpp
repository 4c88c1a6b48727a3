#include "proofs/rules/elimination.hpp"

#include <algorithm>

#include "proofs/branch/facts.hpp"
#include "proofs/branch/normal_form.hpp"
#include "proofs/branch/reduction.hpp"
#include "proofs/branch/signs.hpp"

namespace slipproof::prove {

namespace {

/// A product of two variables, both only there, and declared after all others: F * sigma = P.
std::optional<Rule> rule_for_product(const Fact& equation) {
  const Polynomial& p = equation.p;
  const std::vector<std::size_t> variables = p.variables();
  if (variables.size() != 3 || p.length() != 2) return std::nullopt;
  const Polynomial product = p.coefficient(variables[1], 1).coefficient(variables[2], 1);
  const Polynomial single = p.coefficient(variables[0], 1);
  if (!product.is_constant() || product.is_zero() || !single.is_constant() || single.is_zero()) return std::nullopt;
  const Rational c = product.constant();
  if (absolute(c) != 1) return std::nullopt;
  return Rule{equation, variables[1], variables[2], Polynomial(p.ring(), 1), {1, {}}, p, c > 0 ? 1 : -1};
}

/// Once for each circle.
std::optional<Rule> rule_for_circle(const State& state, const Fact& equation) {
  const Polynomial& p = equation.p;
  const auto is_its = [&](const Rule& rule) { return rule.equation.name == equation.name; };
  if (!is_circle(p) || std::any_of(state.rules.begin(), state.rules.end(), is_its)) return std::nullopt;
  const std::vector<std::size_t> variables = p.variables();
  const int orientation = p.coefficient(variables[0], 2).constant() > 0 ? 1 : -1;
  return Rule{equation, variables[0], variables[1], Polynomial(p.ring(), 1), {1, {}}, p, orientation, true};
}

/// Nothing where the sign of the pivot is not known.
std::optional<Rule> rule_for(Context& context, State& state, const Fact& equation, std::size_t variable,
                             const Polynomial& pivot) {
  auto known = as_known_product(context, state, pivot);
  if (!known) return std::nullopt;
  const int orientation = known->coefficient > 0 ? 1 : -1;
  known->coefficient = absolute(known->coefficient);
  return Rule{equation,          variable,
              std::nullopt,      pivot.scaled(orientation),
              *std::move(known), equation.p.coefficient(variable, 0).scaled(orientation),
              orientation};
}

/// The cheapest equation to eliminate with: constant pivots first, then pivots of known sign; variables declared last
/// go first. A parameter is never expressed by unknowns.
std::optional<Rule> find_rule(Context& context, State& state, std::size_t first) {
  const std::size_t first_unknown = context.statement().first_unknown();
  std::optional<Rule> best;
  std::pair<std::size_t, std::size_t> best_cost;
  for (const Fact& fact : state.facts) {
    if (fact.sign != Sign::zero) continue;
    if (auto rule = rule_for_product(fact)) return rule;
    if (auto rule = context.reach.circles ? rule_for_circle(state, fact) : std::nullopt) return rule;
    const std::vector<std::size_t> variables = fact.p.variables();
    for (const std::size_t variable : variables) {
      if (variable < first || fact.p.degree(variable) != 1) continue;
      if (variable < first_unknown && variables.back() >= first_unknown) continue;
      const Polynomial pivot = fact.p.coefficient(variable, 1);
      const std::pair<std::size_t, std::size_t> cost{pivot.is_constant() ? 0 : pivot.length(), 1000 - variable};
      if (best && best_cost <= cost) continue;
      auto rule = rule_for(context, state, fact, variable, pivot);
      if (!rule) continue;
      best = std::move(rule);
      best_cost = cost;
    }
  }
  return best;
}

bool touches(const Rule& rule, const Polynomial& p) {
  if (rule.is_circle) return p.degree(rule.variable) > 1 || p.degree(*rule.second) > 1;
  return p.contains(rule.variable) && (!rule.second || p.contains(*rule.second));
}

/// What the rule does not touch stays; the rest comes back reduced. A circle stays among the facts, too, as products
/// and sums of squares use it, and it is a rule until one of its variables is eliminated.
bool apply_rule(Context& context, State& state, const Rule& rule) {
  std::vector<Fact> facts;
  facts.swap(state.facts);
  std::vector<Fact> touched;
  for (Fact& fact : facts) {
    const bool is_rule = fact.name == rule.equation.name;
    if (is_rule && !rule.is_circle) continue;
    (!is_rule && touches(rule, fact.p) ? touched : state.facts).push_back(std::move(fact));
  }
  std::erase_if(state.rules, [&](const Rule& other) {
    return other.is_circle && !rule.second && (other.variable == rule.variable || other.second == rule.variable);
  });
  state.rules.push_back(rule);
  state.unknown_signs.clear();
  for (Fact& fact : touched) {
    reduce(context, state, rule, fact);
    const News news = normalize(context, state, fact);
    if (news == News::contradiction) return true;
    if (news == News::some && add(context, state, std::move(fact))) return true;
  }
  return false;
}

}  // namespace

bool is_circle(const Polynomial& p) {
  const std::vector<std::size_t> variables = p.variables();
  if (variables.size() != 2 || p.length() != 3) return false;
  const Polynomial first = p.coefficient(variables[0], 2), second = p.coefficient(variables[1], 2);
  const Polynomial rest = p.coefficient(variables[0], 0).coefficient(variables[1], 0);
  return first.is_constant() && absolute(first.constant()) == 1 && first == second && !rest.is_zero();
}

bool eliminate(Context& context, State& state, std::size_t first) {
  while (const auto rule = find_rule(context, state, first)) {
    if (apply_rule(context, state, *rule)) return true;
  }
  return false;
}

}  // namespace slipproof::prove
