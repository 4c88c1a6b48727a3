#include "proofs/branch/signs.hpp"

#include "proofs/branch/domination.hpp"

namespace slipproof::prove {

namespace {

/// The quick pass looks at all that two slack variables can do: signs are asked for again and again.
constexpr SlackEffort quick_for_signs{.depth = 2, .attempts = 300};

/// Derives the sign of p, which is negative at the samples in `negative`, if it is positive: that it is > 0, or, where
/// `weak_too`, >= 0.
std::optional<Fact> derive_positive(Context& context, State& state, const Polynomial& p, const SampleSet& negative,
                                    Pass pass, bool weak_too) {
  const SlackEffort effort = pass == Pass::thorough ? context.thorough_slack() : quick_for_signs;
  auto form = find_slack_form(state.facts, state.derived, p, negative, effort, context.replacements());
  if (!form && context.reach.product_degree > 1) form = find_dominated_form(state.facts, p, negative, context.budget());
  if (!form || (!form->strict && !weak_too)) return std::nullopt;
  const Fact fact{context.fresh(), p, form->strict ? Sign::positive : Sign::non_negative};
  Identity identity{form->terms, {}};
  Product negated = form->multiplier;
  negated[fact.name] += 1;
  identity.terms.push_back({1, negated});
  state.steps.push_back(have(fact, {std::move(identity)}));
  state.derived.push_back(fact);
  return fact;
}

}  // namespace

const KnownSign* sign_of(Context& context, State& state, const Polynomial& factor, Pass pass) {
  const std::string& text = factor.text();
  const auto known = state.signs.find(text);
  const bool nothing_known = known == state.signs.end();
  if (!nothing_known && (known->second.strict || pass == Pass::quick)) return &known->second;
  const auto unknown = state.unknown_signs.find(text);
  if (unknown == state.unknown_signs.end() || unknown->second < pass) {
    const auto& [same, negated, pattern] = context.both_signs(factor);
    for (const int orientation : {1, -1}) {
      const SampleSet& negative = orientation > 0 ? pattern.negative : pattern.positive;
      const auto fact =
          derive_positive(context, state, orientation > 0 ? same : negated, negative, pass, nothing_known);
      if (!fact) continue;
      return &(state.signs[text] = KnownSign{orientation, fact->sign == Sign::positive, fact->name});
    }
    state.unknown_signs[text] = pass;
  }
  return nothing_known ? nullptr : &known->second;
}

std::optional<WeightedProduct> as_known_product(Context& context, State& state, const Polynomial& p) {
  const Factorization& factors = context.factored(p);
  WeightedProduct result{factors.constant, {}};
  for (const auto& [factor, exponent] : factors.factors) {
    const KnownSign* sign = sign_of(context, state, factor);
    if (sign == nullptr || !sign->strict) return std::nullopt;
    multiply(result.product, {{sign->name, 1}}, exponent);
    if (sign->orientation < 0 && exponent % 2 == 1) result.coefficient = -result.coefficient;
  }
  return result;
}

}  // namespace slipproof::prove
