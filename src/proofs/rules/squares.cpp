#include "proofs/rules/squares.hpp"

#include "proofs/branch/facts.hpp"
#include "proofs/branch/signs.hpp"
#include "proofs/rules/splits.hpp"

namespace slipproof::prove {

namespace {

/// Splits on factors of even exponent and unknown sign.
bool close_even_factors(Context& context, State& state, const Fact& fact, const Close& close) {
  const Factorization factors = context.factored(fact.p);
  for (const auto& [factor, exponent] : factors.factors) {
    const KnownSign* sign = exponent % 2 == 0 ? sign_of(context, state, factor) : nullptr;
    if (exponent % 2 != 0 || (sign != nullptr && sign->strict)) continue;
    if (close_split(context, state, factor, close)) return true;
  }
  return false;
}

/// Completes a square: p = -A y^2 + b y + c with A > 0, where y is a power of the variable, is above 0 only if
/// D = b^2 + 4 A c is, as D = s^2 + 4 A p for s = b - 2 A y. D > 0 takes the place of p > 0 in the branches for the
/// sign of s.
bool close_square(Context& context, State& state, const Fact& fact, std::size_t variable, const Close& close) {
  const std::size_t half = fact.p.degree(variable) / 2;
  const Polynomial leading = -fact.p.coefficient(variable, 2 * half), linear = fact.p.coefficient(variable, half),
                   rest = fact.p.coefficient(variable, 0),
                   y = power(Polynomial::variable(fact.p.ring(), variable), half);
  if (half == 0 || !(fact.p == linear * y + rest - leading * y * y)) return false;
  const auto known = as_known_product(context, state, leading);
  if (!known || known->coefficient < 0 || known->product.contains(fact.name)) return false;
  const Polynomial root = linear - (leading * y).scaled(2), discriminant = linear * linear + (leading * rest).scaled(4);
  Product product = known->product;
  multiply(product, {{fact.name, 1}});
  return close_split(context, state, root, [&](State& branch, const Fact& sign) {
    Identity identity{{{4 * known->coefficient, product}}, {}};
    if (sign.sign == Sign::zero) {
      identity.equations.emplace_back(sign.name, root);
    } else {
      identity.terms.push_back({1, {{sign.name, 2}}});
    }
    if (discriminant.is_zero()) {
      if (sign.sign == Sign::zero && fact.sign != Sign::positive) return close(branch);
      branch.steps.push_back(contradiction(std::move(identity)));
      return true;
    }
    const Fact next{context.fresh(), discriminant, fact.sign};
    identity.terms.push_back({1, {{next.name, 1}}});
    branch.steps.push_back(have(next, {std::move(identity)}));
    return add(context, branch, next) || close(branch);
  });
}

}  // namespace

bool close_squares(Context& context, State& state, const Close& close) {
  const std::vector<Fact> facts = state.facts;
  for (auto fact = facts.rbegin(); fact != facts.rend(); ++fact) {
    if (fact->sign == Sign::zero) continue;
    if (close_even_factors(context, state, *fact, close)) return true;
    for (const std::size_t variable : fact->p.variables()) {
      if (close_square(context, state, *fact, variable, close)) return true;
    }
  }
  return false;
}

}  // namespace slipproof::prove
