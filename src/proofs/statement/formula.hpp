// Formulas over polynomial sign conditions as the prover sees them; the names that the parts of a formula get as
// hypotheses follow proofs/FORMAT.md.
#pragma once

#include <optional>
#include <vector>

#include "proofs/statement/polynomial.hpp"

namespace slipproof::prove {

enum class Sign { zero, positive, non_negative };  // p = 0, p > 0, p >= 0

struct Formula {
  enum class Kind { atom, conjunction, disjunction };
  Kind kind = Kind::conjunction;
  std::vector<Polynomial> polynomial;  ///< one for an atom, otherwise empty
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

/// p of a formula p != 0, p not the constant zero; otherwise nullptr.
inline const Polynomial* non_zero_polynomial(const Formula& formula) {
  if (formula.kind != Formula::Kind::disjunction || formula.parts.size() != 2) return nullptr;
  for (const Formula& part : formula.parts) {
    if (part.kind != Formula::Kind::atom || part.sign != Sign::positive) return nullptr;
  }
  const Polynomial& p = formula.parts[0].polynomial.front();
  return p == -formula.parts[1].polynomial.front() && !p.is_zero() ? &p : nullptr;
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

/// The truth of the formula, if it does not depend on any variable.
inline std::optional<bool> evident(const Formula& formula) {
  if (formula.kind == Formula::Kind::atom) {
    const Polynomial& p = formula.polynomial.front();
    if (!p.is_constant()) return std::nullopt;
    const Rational value = p.constant();
    return formula.sign == Sign::zero ? value == 0 : formula.sign == Sign::positive ? value > 0 : value >= 0;
  }
  const bool settles = formula.kind == Formula::Kind::disjunction;  // a part of this value settles the whole
  bool open = false;
  for (const Formula& part : formula.parts) {
    const std::optional<bool> truth = evident(part);
    if (truth == settles) return settles;
    open = open || !truth;
  }
  return open ? std::nullopt : std::optional(!settles);
}

}  // namespace slipproof::prove
