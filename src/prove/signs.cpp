// The signs of factors.
#include "prove/state.hpp"

namespace slipproof::prove {

namespace {

/// Factoring cannot be stopped; what is longer is taken for irreducible.
constexpr std::size_t longest_factored = 2'000;

/// The search tries factors in this order.
Factorization short_ones_first(Factorization factorization) {
  std::sort(factorization.factors.begin(), factorization.factors.end(), [](const auto& x, const auto& y) {
    return x.first.length() != y.first.length() ? x.first.length() < y.first.length() : x.first.text() < y.first.text();
  });
  return factorization;
}

}  // namespace

const Factorization& Search::factored(const Polynomial& p) {
  const auto [entry, added] = factorizations_.try_emplace(p.text());
  if (added) {
    budget_.spend(p.length() * 8);
    entry->second = p.length() > longest_factored ? p.as_irreducible() : short_ones_first(p.factors());
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

/// p as a number times a product of strict facts, where the signs of all its factors are known.
std::optional<WeightedProduct> Search::as_known_product(State& state, const Polynomial& p) {
  const Factorization& factors = factored(p);
  WeightedProduct result{factors.constant, {}};
  for (const auto& [factor, exponent] : factors.factors) {
    const KnownSign* sign = sign_of(state, factor);
    if (sign == nullptr || !sign->strict) return std::nullopt;
    multiply(result.product, {{sign->name, 1}}, exponent);
    if (sign->orientation < 0 && exponent % 2 == 1) result.coefficient = -result.coefficient;
  }
  return result;
}

/// Whether the known signs of factors make the formula true; it is not searched for one that is false for a sample
/// outside of `excluded`.
bool Search::implied(State& state, const Formula& formula, const SampleSet& excluded) {
  const auto follows = [&](const Formula& part) { return implied(state, part, excluded); };
  if (formula.kind == Formula::Kind::conjunction) {
    return std::all_of(formula.parts.begin(), formula.parts.end(), follows);
  }
  if (formula.kind == Formula::Kind::disjunction) {
    if (const Polynomial* p = non_zero_polynomial(formula)) {
      const auto& factors = factored(*p).factors;
      return std::all_of(factors.begin(), factors.end(), [&](const auto& factor) {
        const KnownSign* sign = sign_of(state, factor.first);
        return sign != nullptr && sign->strict;
      });
    }
    return std::any_of(formula.parts.begin(), formula.parts.end(), follows);
  }
  const Polynomial& p = formula.polynomial.front();
  if (p.is_constant()) return evident(formula) == true;
  if (formula.sign == Sign::zero || !excluded.contains(signs_at_samples(p).negative)) return false;
  const Factorization& factors = factored(p);
  int orientation = factors.constant > 0 ? 1 : -1;
  for (const auto& [factor, exponent] : factors.factors) {
    const KnownSign* sign = sign_of(state, factor);
    if (sign == nullptr || (formula.sign == Sign::positive && !sign->strict)) return false;
    if (exponent % 2 == 1) orientation *= sign->orientation;
  }
  return orientation > 0;
}

/// Forgets disjunctions that are known to be true: their branches have nothing to say.
void Search::drop_known_cases(State& state) {
  SampleSet excluded;
  for (const Fact& fact : state.facts) {
    if (fact.sign != Sign::zero) excluded |= fact.fails;
  }
  std::erase_if(state.disjunctions, [&](const auto& named) { return implied(state, named.second, excluded); });
}

}  // namespace slipproof::prove
