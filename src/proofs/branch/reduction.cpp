#include "proofs/branch/reduction.hpp"

#include <algorithm>

namespace slipproof::prove {

namespace {

/// pivot^pivots * p = quotient * equation + remainder, the equation as it is oriented in the rule.
struct Division {
  Polynomial quotient, remainder;
  std::size_t pivots = 0;
};

Polynomial monomial(const Ring& ring, const Term& term) {
  Polynomial result(ring, term.coefficient);
  for (std::size_t i = 0; i < ring.size(); ++i) result *= power(Polynomial::variable(ring, i), term.exponents[i]);
  return result;
}

Division divided_by_product(const Rule& rule, const Polynomial& equation, const Polynomial& p) {
  const Ring& ring = p.ring();
  const Polynomial product = Polynomial::variable(ring, rule.variable) * Polynomial::variable(ring, *rule.second);
  Division result{Polynomial(ring), p};
  const auto contains_product = [&](const Term& term) {
    return term.exponents[rule.variable] > 0 && term.exponents[*rule.second] > 0;
  };
  while (true) {
    const std::vector<Term> terms = result.remainder.terms();
    const auto term = std::find_if(terms.begin(), terms.end(), contains_product);
    if (term == terms.end()) return result;
    const Polynomial factor = *monomial(ring, *term).divided_by(product);
    result.quotient += factor;
    result.remainder -= factor * equation;
  }
}

Division divided_by_variable(const Rule& rule, const Polynomial& equation, const Polynomial& p) {
  const std::size_t pivots = p.degree(rule.variable);
  if (pivots == 0) return {Polynomial(p.ring()), p};
  const Polynomial remainder = substitute(p, rule.variable, -rule.rest, rule.pivot);
  return {*(p * power(rule.pivot, pivots) - remainder).divided_by(equation), remainder, pivots};
}

/// The identities by which the result follows from the fact and `multiple` times the equation; for an equation in both
/// directions.
std::vector<Identity> identities(const Rule& rule, const Fact& fact, const Fact& result, std::size_t pivots,
                                 const Polynomial& multiple) {
  const std::string& equation = rule.equation.name;
  const Polynomial multiplier = power(rule.pivot, pivots);
  if (fact.sign == Sign::zero) {
    return {{{{1, {{result.name, 1}}}}, {{fact.name, -multiplier}, {equation, multiple}}},
            {{{1, {{result.name, 1}}}}, {{fact.name, multiplier}, {equation, -multiple}}}};
  }
  WeightedProduct product{1, {{fact.name, 1}}};
  multiply(product.product, rule.pivot_product.product, static_cast<unsigned>(pivots));
  for (std::size_t i = 0; i < pivots; ++i) product.coefficient *= rule.pivot_product.coefficient;
  return {{{std::move(product), {1, {{result.name, 1}}}}, {{equation, -multiple}}}};
}

}  // namespace

void reduce(Context& context, State& state, const Rule& rule, Fact& fact) {
  const Polynomial equation = rule.equation.p.scaled(rule.orientation);
  const Division division =
      rule.second ? divided_by_product(rule, equation, fact.p) : divided_by_variable(rule, equation, fact.p);
  if (division.quotient.is_zero()) return;
  Fact result{context.fresh(), division.remainder, fact.sign};
  state.steps.push_back(
      have(result, identities(rule, fact, result, division.pivots, division.quotient.scaled(rule.orientation))));
  fact = std::move(result);
}

}  // namespace slipproof::prove
