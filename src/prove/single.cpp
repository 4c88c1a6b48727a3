// Strategy: a single fact that the others contradict.
#include "prove/state.hpp"

namespace slipproof::prove {

/// Looks for a strict fact that is a multiple of an equation: one that no pivot of known sign could eliminate with.
bool Search::refute_multiples(State& state) {
  for (const Fact& equation : state.facts) {
    if (equation.sign != Sign::zero) continue;
    for (const Fact& fact : state.facts) {
      if (fact.sign != Sign::positive || fact.p.length() < equation.p.length()) continue;
      const auto quotient = fact.p.divided_by(equation.p);
      if (!quotient) continue;
      state.steps.push_back(contradiction({{{1, {{fact.name, 1}}}}, {{equation.name, -*quotient}}}));
      return true;
    }
  }
  return false;
}

/// Looks for a single fact that the others contradict.
bool Search::refute_facts(State& state, bool thorough) {
  if (refute_multiples(state)) return true;
  for (std::size_t i = 0; i < state.facts.size(); ++i) {
    const Fact fact = state.facts[i];
    if (fact.sign == Sign::zero || (fact.p.length() == 1 && !thorough)) continue;
    const auto form =
        find_slack_form(state.facts, state.derived, -fact.p, signs_at_samples(fact.p).positive,
                        thorough ? limits_.slack_depth : 1, thorough ? limits_.slack_attempts : 100, budget_);
    if (!form || (!form->strict && fact.sign != Sign::positive)) continue;
    Identity identity{form->terms, {}};
    Product product = form->multiplier;
    product[fact.name] += 1;
    identity.terms.push_back({1, product});
    state.steps.push_back(contradiction(std::move(identity)));
    return true;
  }
  return false;
}

}  // namespace slipproof::prove
