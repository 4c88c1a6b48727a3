// Strategy: Fourier-Motzkin elimination of a variable from pairs of facts.
#include "prove/state.hpp"

namespace slipproof::prove {

/// Fourier-Motzkin: two facts linear in a variable, with coefficients of opposite known signs, give one without it.
bool Search::refute_pairs(State& state, std::vector<Polynomial>& candidates, bool thorough) {
  struct Bound {
    Fact fact;
    Product coefficient;  ///< times `constant` > 0
    Rational constant;
    Polynomial rest;
    Polynomial magnitude;
    bool strict_coefficient;
  };
  const Ring& ring = statement_.ring();
  for (std::size_t variable = ring.size(); variable-- > 0;) {
    std::vector<Bound> lower;
    std::vector<Bound> upper;
    const std::vector<Fact> facts = state.facts;
    for (const Fact& fact : facts) {
      if (fact.sign == Sign::zero || fact.p.degree(variable) != 1) continue;
      const Polynomial c = fact.p.coefficient(variable, 1);
      const Factorization& factors = factored(c);
      Rational constant = factors.constant;
      Product product;
      bool known = true;
      bool strict = true;
      for (const auto& [factor, exponent] : factors.factors) {
        const KnownSign* sign = sign_of(state, factor, thorough);
        if (sign == nullptr) {
          candidates.push_back(factor);
          known = false;
          continue;
        }
        multiply(product, {{sign->name, 1}}, exponent);
        if (sign->orientation < 0 && exponent % 2 == 1) constant = -constant;
        strict = strict && sign->strict;
      }
      if (!known) continue;
      if (product.contains(fact.name)) continue;
      (constant > 0 ? lower : upper)
          .push_back(
              {fact, product, absolute(constant), fact.p.coefficient(variable, 0), constant > 0 ? c : -c, strict});
    }
    for (const Bound& l : lower) {
      for (const Bound& u : upper) {
        const Polynomial r = l.rest * u.magnitude + u.rest * l.magnitude;
        Product left = u.coefficient;
        multiply(left, {{l.fact.name, 1}});
        Product right = l.coefficient;
        multiply(right, {{u.fact.name, 1}});
        Identity identity{{{u.constant, left}, {l.constant, right}}, {}};
        const bool strict = (l.fact.sign == Sign::positive && u.strict_coefficient) ||
                            (u.fact.sign == Sign::positive && l.strict_coefficient);
        if (r.is_zero()) {
          if (!strict) continue;
          state.steps.push_back(contradiction(std::move(identity)));
          return true;
        }
        const Factorization& factors = factored(r);
        Rational constant = factors.constant;
        Product product;
        bool known = true;
        bool strict_sign = true;
        std::vector<Polynomial> open;
        for (const auto& [factor, exponent] : factors.factors) {
          const KnownSign* sign = sign_of(state, factor, thorough);
          if (sign == nullptr) {
            known = false;
            open.push_back(factor);
            continue;
          }
          multiply(product, {{sign->name, 1}}, exponent);
          if (sign->orientation < 0 && exponent % 2 == 1) constant = -constant;
          strict_sign = strict_sign && sign->strict;
        }
        if (known && constant < 0 && (strict || strict_sign)) {
          identity.terms.push_back({absolute(constant), product});
          state.steps.push_back(contradiction(std::move(identity)));
          return true;
        }
        if (!known && open.size() == 1) candidates.push_back(open.front());
      }
    }
  }
  return false;
}

}  // namespace slipproof::prove
