#include "proofs/rules/single_facts.hpp"

#include <algorithm>

#include "proofs/branch/domination.hpp"

namespace slipproof::prove {

namespace {

constexpr SlackEffort quick_for_facts{.depth = 1, .attempts = 100};

/// A strict fact that is a multiple of an equation: one that no pivot of known sign could eliminate with.
bool refute_multiple(State& state) {
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

/// A fact p > 0, or p >= 0, while -p is positive by the others.
bool refute_by_slack(Context& context, State& state, const Fact& fact, Pass pass) {
  const SlackEffort effort = pass == Pass::thorough ? context.thorough_slack() : quick_for_facts;
  const auto& [same, negated, pattern] = context.both_signs(fact.p);
  auto form = find_slack_form(state.facts, state.derived, negated, pattern.positive, effort, context.replacements());
  if (!form && pass == Pass::thorough && context.reach.product_degree > 1)
    form = find_dominated_form(state.facts, negated, pattern.positive, context.budget());
  if (!form || (!form->strict && fact.sign != Sign::positive)) return false;
  Identity identity{form->terms, {}};
  Product product = form->multiplier;
  product[fact.name] += 1;
  identity.terms.push_back({1, product});
  state.steps.push_back(contradiction(std::move(identity)));
  return true;
}

}  // namespace

bool refute_single_fact(Context& context, State& state, Pass pass) {
  if (refute_multiple(state)) return true;
  return std::any_of(state.facts.begin(), state.facts.end(), [&](const Fact& fact) {
    if (fact.sign == Sign::zero || (fact.p.length() == 1 && pass == Pass::quick)) return false;
    return refute_by_slack(context, state, fact, pass);
  });
}

}  // namespace slipproof::prove
