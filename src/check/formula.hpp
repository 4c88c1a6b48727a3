// Formulas over sign conditions of polynomials, in negation normal form.
#pragma once

#include <utility>
#include <vector>

#include "check/polynomial.hpp"

namespace slipproof::check {

enum class Relation { zero, positive, non_negative };  // p = 0, p > 0, p >= 0

/// An atom, or a conjunction or disjunction of parts; without parts the one is true, the other false.
struct Formula {
  enum class Kind { atom, conjunction, disjunction } kind = Kind::conjunction;
  Polynomial polynomial;
  Relation relation = Relation::zero;
  std::vector<Formula> parts;
};

inline Formula atom(Polynomial p, Relation relation) {
  return {Formula::Kind::atom, std::move(p), relation, {}};
}

/// A list of one part is that part.
inline Formula combine(Formula::Kind kind, std::vector<Formula> parts) {
  if (parts.size() == 1) return Formula(std::move(parts.front()));
  return {kind, {}, {}, std::move(parts)};
}

inline Formula non_zero(const Polynomial& p) {  // p > 0 or -p > 0
  return combine(Formula::Kind::disjunction, {atom(p, Relation::positive), atom(-p, Relation::positive)});
}

inline Formula negation(const Formula& formula) {
  using enum Formula::Kind;
  if (formula.kind == atom) {
    if (formula.relation == Relation::zero) return non_zero(formula.polynomial);
    const bool strict = formula.relation == Relation::positive;
    return check::atom(-formula.polynomial, strict ? Relation::non_negative : Relation::positive);
  }
  Formula result{formula.kind == conjunction ? disjunction : conjunction, {}, {}, {}};
  for (const Formula& part : formula.parts) result.parts.push_back(negation(part));
  return result;
}

inline std::size_t size(const Formula& formula) {
  std::size_t result = 1;
  for (const Formula& part : formula.parts) result += size(part);
  return result;
}

}  // namespace slipproof::check
