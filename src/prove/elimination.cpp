// Linear elimination: equations that determine a variable, or a product of two.
#include "prove/state.hpp"

namespace slipproof::prove {

/// The cheapest equation to eliminate with: constant pivots first, then pivots of known sign; variables declared last
/// go first.
std::optional<Search::Rule> Search::find_rule(State& state, std::size_t first) {
  std::optional<Rule> best;
  std::pair<std::size_t, std::size_t> best_cost;
  std::vector<Fact> equations;
  for (const Fact& fact : state.facts) {
    if (fact.sign == Sign::zero) equations.push_back(fact);
  }
  for (const Fact& fact : equations) {
    const std::vector<std::size_t> variables = fact.p.variables();
    // A product of two variables, both only there, and declared after all others: F * sigma = P.
    if (variables.size() == 3 && fact.p.length() == 2) {
      const Polynomial product = fact.p.coefficient(variables[1], 1).coefficient(variables[2], 1);
      const Polynomial single = fact.p.coefficient(variables[0], 1);
      if (product.is_constant() && !product.is_zero() && single.is_constant() && !single.is_zero()) {
        const Rational c = product.constant();
        if (absolute(c) == 1) {
          const int orientation = c > 0 ? 1 : -1;
          return Rule{fact, variables[1], variables[2], Polynomial(fact.p.ring(), 1), 1, {}, fact.p, orientation};
        }
      }
    }
    for (const std::size_t variable : variables) {
      if (variable < first || fact.p.degree(variable) != 1) continue;
      if (variable < statement_.first_unknown() && variables.back() >= statement_.first_unknown()) continue;
      Polynomial pivot = fact.p.coefficient(variable, 1);
      const std::pair<std::size_t, std::size_t> cost{pivot.is_constant() ? 0 : pivot.length(), 1000 - variable};
      if (best && best_cost <= cost) continue;
      const auto known = as_known_product(state, pivot);
      if (!known) continue;
      const int orientation = known->coefficient > 0 ? 1 : -1;
      best = Rule{fact,
                  variable,
                  std::nullopt,
                  pivot.scaled(orientation),
                  absolute(known->coefficient),
                  known->product,
                  fact.p.coefficient(variable, 0).scaled(orientation),
                  orientation};
      best_cost = cost;
    }
  }
  return best;
}

bool Search::apply_rule(State& state, const Rule& rule) {
  std::vector<Fact> facts;
  facts.swap(state.facts);
  // What the rule does not touch stays; the rest comes back reduced.
  std::vector<Fact> touched;
  for (Fact& fact : facts) {
    if (fact.name == rule.equation.name) continue;
    const bool contains = fact.p.contains(rule.variable) && (!rule.second || fact.p.contains(*rule.second));
    (contains ? touched : state.facts).push_back(std::move(fact));
  }
  state.rules.push_back(rule);
  state.unknown_signs.clear();
  for (Fact& fact : touched) {
    reduce(state, state.rules.back(), fact);
    bool keep = true;
    if (normalize(state, fact, keep)) return true;
    if (keep) {
      if (add(state, std::move(fact))) return true;
    }
  }
  return false;
}

/// Eliminates with every equation that allows it.
bool Search::eliminate(State& state, std::size_t first) {
  while (const auto rule = find_rule(state, first)) {
    if (apply_rule(state, *rule)) return true;
  }
  return false;
}

}  // namespace slipproof::prove
