#include "proofs/branch/normal_form.hpp"

#include "proofs/branch/signs.hpp"

namespace slipproof::prove {

namespace {

/// p = constant * the known product * the unknown factors, signs of the known ones taken into the constant.
struct Separated {
  Rational constant;
  Product known;
  std::vector<std::pair<Polynomial, unsigned>> unknown;
};

Separated separate(Context& context, State& state, const Fact& fact) {
  const Factorization& factors = context.factored(fact.p);
  Separated result{factors.constant, {}, {}};
  for (const auto& [factor, exponent] : factors.factors) {
    const KnownSign* sign = sign_of(context, state, factor);
    if (sign == nullptr || !sign->strict || sign->name == fact.name) {
      result.unknown.emplace_back(factor, exponent);
      continue;
    }
    multiply(result.known, {{sign->name, 1}}, exponent);
    if (sign->orientation < 0 && exponent % 2 == 1) result.constant = -result.constant;
  }
  return result;
}

/// Where p is 0.
News settle_zero(State& state, const Fact& fact) {
  if (fact.sign != Sign::positive) return News::none;
  state.steps.push_back(contradiction({{{1, {{fact.name, 1}}}}, {}}));
  return News::contradiction;
}

/// Where all factors are known.
News settle(State& state, const Fact& fact, const Separated& p) {
  const WeightedProduct value{absolute(p.constant), p.known};
  if (fact.sign == Sign::zero) {
    const Polynomial multiplier(fact.p.ring(), p.constant > 0 ? -1 : 1);
    state.steps.push_back(contradiction({{value}, {{fact.name, multiplier}}}));
    return News::contradiction;
  }
  if (p.constant > 0) return News::none;
  state.steps.push_back(contradiction({{{1, {{fact.name, 1}}}, value}, {}}));
  return News::contradiction;
}

/// That |constant| * known * rest^exponent = p gives `result` about the rest; for an equation in both directions.
std::vector<Identity> identities(const Fact& fact, const Separated& p, const Fact& result, unsigned exponent) {
  WeightedProduct opposite{absolute(p.constant), p.known};
  opposite.product[result.name] += exponent;
  if (fact.sign != Sign::zero) return {{{std::move(opposite), {1, {{fact.name, 1}}}}, {}}};
  // For an even exponent the sign of the rest does not matter, and both identities are alike.
  const bool even = exponent % 2 == 0;
  const int sign = even && p.constant < 0 ? -1 : 1;
  const Ring& ring = fact.p.ring();
  return {{{opposite}, {{fact.name, Polynomial(ring, -sign)}}},
          {{opposite}, {{fact.name, Polynomial(ring, even ? -sign : 1)}}}};
}

}  // namespace

News normalize(Context& context, State& state, Fact& fact) {
  if (fact.p.is_zero()) return settle_zero(state, fact);
  const Separated p = separate(context, state, fact);
  if (p.unknown.empty()) return settle(state, fact, p);
  const auto& [first, power_of_first] = p.unknown.front();
  const bool single = p.unknown.size() == 1 && (fact.sign == Sign::zero || power_of_first % 2 == 1);
  if (p.known.empty() && (!single || (power_of_first == 1 && absolute(p.constant) == 1))) return News::some;
  Polynomial rest(fact.p.ring(), 1);
  if (single) {
    rest = first;
  } else {
    for (const auto& [factor, exponent] : p.unknown) rest *= power(factor, exponent);
  }
  if (p.constant < 0) rest = -rest;
  Fact result{context.fresh(), rest, fact.sign};
  state.steps.push_back(have(result, identities(fact, p, result, single ? power_of_first : 1)));
  fact = std::move(result);
  return News::some;
}

}  // namespace slipproof::prove
