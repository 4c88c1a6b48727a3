#include "proofs/branch/facts.hpp"

#include <algorithm>

#include "proofs/branch/normal_form.hpp"
#include "proofs/branch/reduction.hpp"

namespace slipproof::prove {

namespace {

void reduce_by_rules(Context& context, State& state, Fact& fact) {
  for (std::string before; before != fact.name;) {  // a later rule may bring back the product of an earlier one
    before = fact.name;
    for (const Rule& rule : state.rules) reduce(context, state, rule, fact);
  }
}

/// Takes down what an inequality says of the sign of its only factor; that factor if nothing so strict was known of it.
std::optional<Polynomial> note_sign(Context& context, State& state, const Fact& fact) {
  state.unknown_signs.clear();
  const Factorization& f = context.factored(fact.p);
  if (f.factors.size() != 1 || f.factors[0].second != 1 || absolute(f.constant) != 1) return std::nullopt;
  const Polynomial& factor = f.factors[0].first;
  KnownSign& known = state.signs[factor.text()];
  if (!known.name.empty() && known.strict) return std::nullopt;
  known = {f.constant > 0 ? 1 : -1, fact.sign == Sign::positive, fact.name};
  return known.strict ? std::optional(factor) : std::nullopt;
}

/// Shortens the facts with a factor whose sign has become known; true if one is contradictory then.
bool divide_out(Context& context, State& state, const Polynomial& factor) {
  std::vector<Fact> touched;
  std::erase_if(state.facts, [&](const Fact& fact) {
    const Factorization& factors = context.factored(fact.p);
    const bool touches =
        factors.factors.size() > 1 && std::any_of(factors.factors.begin(), factors.factors.end(),
                                                  [&](const auto& other) { return other.first == factor; });
    if (touches) touched.push_back(fact);
    return touches;
  });
  return std::any_of(touched.begin(), touched.end(), [&](Fact& fact) { return add(context, state, std::move(fact)); });
}

}  // namespace

bool add_formula(Context& context, State& state, const std::string& name, const Formula& formula) {
  if (formula.kind == Formula::Kind::atom) return add(context, state, {name, formula.polynomial.front(), formula.sign});
  if (formula.kind == Formula::Kind::disjunction) {
    if (evident(formula) == true) return false;  // nothing to learn from it
    state.disjunctions.emplace_back(name, formula);
    return false;
  }
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    if (add_formula(context, state, name + "." + std::to_string(i + 1), formula.parts[i])) return true;
  }
  return false;
}

bool add(Context& context, State& state, Fact fact) {
  reduce_by_rules(context, state, fact);
  const News news = normalize(context, state, fact);
  if (news != News::some) return news == News::contradiction;
  for (const Fact& other : state.facts) {
    if (other.sign == fact.sign && other.p == fact.p) return false;
  }
  std::optional<Polynomial> settled;
  if (fact.sign != Sign::zero) settled = note_sign(context, state, fact);
  fact.fails = context.fails(fact);
  state.facts.push_back(std::move(fact));
  return settled && divide_out(context, state, *settled);
}

}  // namespace slipproof::prove
