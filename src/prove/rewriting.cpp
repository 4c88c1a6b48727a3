// Facts coming into a state: brought to a short form by what is known already.
#include "prove/state.hpp"

namespace slipproof::prove {

bool Search::add_formula(State& state, const std::string& name, const Formula& formula) {
  if (formula.kind == Formula::Kind::atom) return add(state, {name, formula.polynomial.front(), formula.sign});
  if (formula.kind == Formula::Kind::disjunction) {
    if (evident(formula) == true) return false;  // nothing to learn from it
    state.disjunctions.emplace_back(name, formula);
    return false;
  }
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    if (add_formula(state, name + "." + std::to_string(i + 1), formula.parts[i])) return true;
  }
  return false;
}

/// Brings a new fact into the state; true if the state is contradictory, its steps then end in the contradiction.
bool Search::add(State& state, Fact fact) {
  for (std::string before; before != fact.name;) {  // a later rule may bring back the product of an earlier one
    before = fact.name;
    for (const Rule& rule : state.rules) reduce(state, rule, fact);
  }
  bool keep = true;
  if (normalize(state, fact, keep)) return true;
  if (!keep) return false;
  for (const Fact& other : state.facts) {
    if (other.sign == fact.sign && other.p == fact.p) return false;
  }
  std::optional<Polynomial> shorten;
  if (fact.sign != Sign::zero) {
    state.unknown_signs.clear();
    const Factorization& f = factored(fact.p);
    if (f.factors.size() == 1 && f.factors[0].second == 1 && absolute(f.constant) == 1) {
      KnownSign& known = state.signs[f.factors[0].first.text()];
      if (known.name.empty() || !known.strict) {
        known = {f.constant > 0 ? 1 : -1, fact.sign == Sign::positive, fact.name};
        if (known.strict) shorten = f.factors[0].first;
      }
    }
  }
  fact.fails = fails(fact);
  state.facts.push_back(std::move(fact));
  return shorten && divide_out(state, *shorten);
}

/// Shortens the facts with a factor whose sign has become known; true if one is contradictory then.
bool Search::divide_out(State& state, const Polynomial& factor) {
  std::vector<Fact> touched;
  std::erase_if(state.facts, [&](const Fact& fact) {
    const Factorization& factors = factored(fact.p);
    const bool touches =
        factors.factors.size() > 1 && std::any_of(factors.factors.begin(), factors.factors.end(),
                                                  [&](const auto& other) { return other.first == factor; });
    if (touches) touched.push_back(fact);
    return touches;
  });
  for (Fact& fact : touched) {
    if (add(state, std::move(fact))) return true;
  }
  return false;
}

/// Subtracts multiples of the rule's equation until the fact no longer contains its variable (or product).
void Search::reduce(State& state, const Rule& rule, Fact& fact) {
  const Ring& ring = fact.p.ring();
  Polynomial reduced = fact.p;
  Polynomial quotient(ring);
  std::size_t pivots = 0;
  const Polynomial equation = rule.equation.p.scaled(rule.orientation);
  if (rule.second) {
    const Polynomial product = Polynomial::variable(ring, rule.variable) * Polynomial::variable(ring, *rule.second);
    bool again = true;
    while (again) {
      again = false;
      for (const Term& term : reduced.terms()) {
        if (term.exponents[rule.variable] == 0 || term.exponents[*rule.second] == 0) continue;
        Polynomial monomial(ring, term.coefficient);
        for (std::size_t i = 0; i < ring.size(); ++i) {
          monomial *= power(Polynomial::variable(ring, i), term.exponents[i]);
        }
        const Polynomial factor = *monomial.divided_by(product);
        quotient += factor;
        reduced -= factor * equation;
        again = true;
        break;
      }
    }
    if (quotient.is_zero()) return;
  } else {
    pivots = fact.p.degree(rule.variable);
    if (pivots == 0) return;
    reduced = substitute(fact.p, rule.variable, -rule.rest, rule.pivot);
    quotient = *(fact.p * power(rule.pivot, pivots) - reduced).divided_by(equation);
  }
  const Polynomial multiplier = power(rule.pivot, pivots);
  Fact result{fresh(), reduced, fact.sign};
  const Polynomial equation_multiple = quotient.scaled(rule.orientation);
  std::vector<Identity> identities;
  if (fact.sign == Sign::zero) {
    identities.push_back(
        {{{1, {{result.name, 1}}}}, {{fact.name, -multiplier}, {rule.equation.name, equation_multiple}}});
    identities.push_back(
        {{{1, {{result.name, 1}}}}, {{fact.name, multiplier}, {rule.equation.name, -equation_multiple}}});
  } else {
    Product product = {{fact.name, 1}};
    multiply(product, rule.pivot_product, static_cast<unsigned>(pivots));
    Rational coefficient = 1;
    for (std::size_t i = 0; i < pivots; ++i) coefficient *= rule.pivot_constant;
    identities.push_back(
        {{{coefficient, product}, {1, {{result.name, 1}}}}, {{rule.equation.name, -equation_multiple}}});
  }
  state.steps.push_back(have(result, std::move(identities)));
  fact = std::move(result);
}

/// Drops factors of known sign, and settles what is trivially true (keep = false) or false (returns true).
bool Search::normalize(State& state, Fact& fact, bool& keep) {
  if (fact.p.is_zero()) {
    keep = false;
    if (fact.sign != Sign::positive) return false;
    state.steps.push_back(contradiction({{{1, {{fact.name, 1}}}}, {}}));
    return true;
  }
  const Factorization& factors = factored(fact.p);
  Rational constant = factors.constant;
  Product known;
  std::vector<std::pair<Polynomial, unsigned>> unknown;
  for (const auto& [factor, exponent] : factors.factors) {
    const KnownSign* sign = sign_of(state, factor);
    if (sign == nullptr || !sign->strict || sign->name == fact.name) {
      unknown.emplace_back(factor, exponent);
      continue;
    }
    multiply(known, {{sign->name, 1}}, exponent);
    if (sign->orientation < 0 && exponent % 2 == 1) constant = -constant;
  }
  const Polynomial one(fact.p.ring(), 1);
  if (unknown.empty()) {
    keep = false;
    if (fact.sign == Sign::zero) {
      state.steps.push_back(
          contradiction({{{absolute(constant), known}}, {{fact.name, one.scaled(constant > 0 ? -1 : 1)}}}));
      return true;
    }
    if (constant > 0) return false;
    state.steps.push_back(contradiction({{{1, {{fact.name, 1}}}, {absolute(constant), known}}, {}}));
    return true;
  }
  const bool single = unknown.size() == 1 && (fact.sign == Sign::zero || unknown[0].second % 2 == 1);
  if (known.empty() && (!single || (unknown[0].second == 1 && absolute(constant) == 1))) return false;
  Polynomial rest = one;
  if (single) {
    rest = unknown[0].first;
  } else {
    for (const auto& [factor, exponent] : unknown) rest *= power(factor, exponent);
  }
  const unsigned exponent = single ? unknown[0].second : 1;
  if (constant < 0) rest = -rest;  // |constant| * known * rest^exponent = p
  Fact result{fresh(), rest, fact.sign};
  Product opposite = known;
  opposite[result.name] += exponent;
  std::vector<Identity> identities;
  if (fact.sign == Sign::zero) {
    // For an even exponent the sign of rest does not matter, and both identities are alike.
    const bool even = exponent % 2 == 0;
    const int sign = even && constant < 0 ? -1 : 1;
    identities.push_back({{{absolute(constant), opposite}}, {{fact.name, one.scaled(-sign)}}});
    identities.push_back({{{absolute(constant), opposite}}, {{fact.name, one.scaled(even ? -sign : 1)}}});
  } else {
    identities.push_back({{{absolute(constant), opposite}, {1, {{fact.name, 1}}}}, {}});
  }
  state.steps.push_back(have(result, std::move(identities)));
  fact = std::move(result);
  return false;
}

}  // namespace slipproof::prove
