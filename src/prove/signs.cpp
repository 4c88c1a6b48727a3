// The signs of factors.
#include "prove/state.hpp"

namespace slipproof::prove {

const Factorization& Search::factored(const Polynomial& p) {
  const auto [entry, added] = factorizations_.try_emplace(p.text());
  if (added) {
    budget_.spend(p.length() * 8);
    entry->second = p.factors();
  }
  return entry->second;
}

const SignPattern& Search::signs_at_samples(const Polynomial& p) {
  const auto [entry, added] = patterns_.try_emplace(p.text());
  if (added) {
    budget_.spend(p.length() * 4);
    entry->second = samples_.signs(p);
  }
  return entry->second;
}

SampleSet Search::fails(const Fact& fact) {
  const SignPattern& pattern = signs_at_samples(fact.p);
  return fact.sign == Sign::zero ? pattern.negative | pattern.positive : pattern.negative;
}

/// The sign of an irreducible polynomial, as a fact; nullptr while unknown.
const Search::KnownSign* Search::sign_of(State& state, const Polynomial& factor, bool thorough) {
  const std::string text = factor.text();
  const auto known = state.signs.find(text);
  if (known != state.signs.end() && (known->second.strict || !thorough)) return &known->second;
  const auto unknown = state.unknown_signs.find(text);
  if (unknown == state.unknown_signs.end() || (thorough && !unknown->second)) {
    const SignPattern& pattern = signs_at_samples(factor);
    for (const int orientation : {1, -1}) {
      const SampleSet& negative = orientation > 0 ? pattern.negative : pattern.positive;
      const auto form =
          find_slack_form(state.facts, state.derived, factor.scaled(orientation), negative,
                          thorough ? limits_.slack_depth : 2, thorough ? limits_.slack_attempts : 300, budget_);
      if (!form || (!form->strict && known != state.signs.end())) continue;
      Fact fact{fresh(), factor.scaled(orientation), form->strict ? Sign::positive : Sign::non_negative};
      Identity identity{form->terms, {}};
      Product negated = form->multiplier;
      negated[fact.name] += 1;
      identity.terms.push_back({1, negated});
      state.steps.push_back(have(fact, {identity}));
      state.derived.push_back(fact);
      return &(state.signs[text] = KnownSign{orientation, form->strict, fact.name});
    }
    state.unknown_signs[text] = thorough;
  }
  return known != state.signs.end() ? &known->second : nullptr;
}

/// Forgets disjunctions p > 0 or p < 0 where the sign is known: their branches have nothing to say.
void Search::drop_known_cases(State& state) {
  for (std::size_t i = 0; i < state.disjunctions.size();) {
    const Formula& formula = state.disjunctions[i].second;
    bool useless = false;
    if (formula.parts.size() == 2 && formula.parts[0].kind == Formula::Kind::atom &&
        formula.parts[1].kind == Formula::Kind::atom && formula.parts[0].sign == Sign::positive &&
        formula.parts[1].sign == Sign::positive &&
        formula.parts[0].polynomial.front() == -formula.parts[1].polynomial.front()) {
      useless = !formula.parts[0].polynomial.front().is_zero();
      for (const auto& [factor, exponent] : factored(formula.parts[0].polynomial.front()).factors) {
        const KnownSign* sign = sign_of(state, factor);
        if (sign == nullptr || !sign->strict) useless = false;
      }
    }
    if (useless) {
      state.disjunctions.erase(state.disjunctions.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

}  // namespace slipproof::prove
