// Formulas over polynomial sign conditions as the prover sees them; the names that the parts of a formula get as
// hypotheses follow proofs/FORMAT.md.
#pragma once

#include <vector>

#include "prove/polynomial.hpp"

namespace slipproof::prove {

enum class Sign { zero, positive, non_negative };  // p = 0, p > 0, p >= 0

struct Formula {
  enum class Kind { atom, conjunction, disjunction };
  Kind kind = Kind::conjunction;
  std::vector<Polynomial> polynomial;  ///< of an atom: one
  Sign sign = Sign::zero;
  std::vector<Formula> parts;
};

inline Formula atom(Polynomial polynomial, Sign sign) {
  return {Formula::Kind::atom, {std::move(polynomial)}, sign, {}};
}

inline Formula combine(Formula::Kind kind, std::vector<Formula> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  return {kind, {}, Sign::zero, std::move(parts)};
}

inline Formula non_zero(const Polynomial& p) {
  return combine(Formula::Kind::disjunction, {atom(p, Sign::positive), atom(-p, Sign::positive)});
}

inline Formula negation(const Formula& formula) {
  if (formula.kind == Formula::Kind::atom) {
    const Polynomial& p = formula.polynomial.front();
    if (formula.sign == Sign::zero) return non_zero(p);
    return atom(-p, formula.sign == Sign::positive ? Sign::non_negative : Sign::positive);
  }
  Formula result{formula.kind == Formula::Kind::conjunction ? Formula::Kind::disjunction : Formula::Kind::conjunction,
                 {},
                 Sign::zero,
                 {}};
  for (const Formula& part : formula.parts) result.parts.push_back(negation(part));
  return result;
}

}  // namespace slipproof::prove
