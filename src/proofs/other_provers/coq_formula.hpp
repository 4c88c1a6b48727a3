// Names, polynomials and sign conditions as Coq reads them.
#pragma once

#include <string>
#include <vector>

#include "proofs/statement/formula.hpp"

namespace slipproof::coq {

/// A name of a statement as one of Coq's: some are taken by it or by the proof, and it has none with dots. Different
/// names stay different.
std::string name(const std::string& statement_name);

/// scale * p, which has integer coefficients.
std::string text(const prove::Polynomial& p, const Integer& scale = 1);

/// prove::Formula with the polynomials as they are written in the proof: what is negated there is `- (...)`.
struct Formula {
  using Kind = prove::Formula::Kind;
  Kind kind = Kind::conjunction;
  std::string polynomial;
  prove::Sign sign = prove::Sign::zero;
  std::vector<Formula> parts;
};

Formula atom(std::string polynomial, prove::Sign sign);
Formula combine(Formula::Kind kind, std::vector<Formula> parts);
Formula non_zero(const std::string& polynomial);
Formula negation(const Formula& formula);

/// The proposition; `inner`: in parentheses where it is not an atom.
std::string text(const Formula& formula, bool inner = false);

/// A term that proves `formula \/ negation(formula)`.
std::string either(const Formula& formula);

/// Operands joined as they associate, `f (a) (f (b) (c))`.
std::string right_nested(const std::string& function, const std::vector<std::string>& operands);

/// The lemmas that every exported proof uses, a module `Steps`.
extern const char* const kSteps;

}  // namespace slipproof::coq
