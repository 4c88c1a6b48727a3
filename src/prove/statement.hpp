// Statements (proofs/FORMAT.md) as the prover reads them. The prover is not trusted, so this reader may be wrong
// without harm: the checker reads the file itself.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "claims/expression.hpp"
#include "prove/formula.hpp"

namespace slipproof::prove {

/// numerator / denominator, unreduced, with the divisors that must not vanish, in the order of the text.
struct Fraction {
  Polynomial numerator;
  Polynomial denominator;
  std::vector<Polynomial> divisors;
};

/// A formula of a statement in the grammar of claims: for the name of a formula stands the comparison `NAME = 0`, and a
/// conjunction or disjunction has as many operands as the text joins, each pair of braces a node of its own: on that
/// rest the names of its parts as hypotheses. Throws ExpressionError.
Expression parse_formula(const std::string& text, const std::function<bool(const std::string&)>& names_formula);

/// The parts of such a conjunction or disjunction; of anything else itself.
std::vector<Expression> parts(const Expression& formula);

class Statement {
 public:
  /// Throws InputError with the place of the first mistake in `text`, the content of the file `name`.
  Statement(const std::string& name, const std::string& text);

  const Ring& ring() const { return *ring_; }
  const std::string& theorem() const { return theorem_; }
  std::string fingerprint() const;
  const std::vector<std::pair<std::string, Formula>>& assumptions() const { return assumptions_; }
  /// Variables that the conclusion asks to exist, by index in the ring; the other variables come before them.
  const std::vector<std::size_t>& unknowns() const { return unknowns_; }
  /// The first variable declared after an assumption: from there on they are unknowns of a motion, before, parameters.
  std::size_t first_unknown() const { return first_unknown_; }
  /// Polynomials named on lines `# split: EXPRESSION`, worth a case split.
  const std::vector<Polynomial>& hints() const { return hints_; }
  /// The conclusion with values for the unknowns, or, with none, in the unknowns as variables.
  Formula shown(const std::vector<std::string>& witness = {}) const;
  /// The divisors of the values of a witness, in their order.
  std::vector<Polynomial> divisors(const std::vector<std::string>& witness) const;

 private:
  struct Reader;
  Reader variables() const;
  std::string file_;
  std::string text_;
  std::unique_ptr<Ring> ring_;
  std::string theorem_;
  std::uint64_t fingerprint_ = 14695981039346656037U;
  std::vector<std::pair<std::string, Formula>> assumptions_;
  std::vector<std::size_t> unknowns_;
  std::size_t first_unknown_ = 0;
  std::vector<Polynomial> hints_;
};

}  // namespace slipproof::prove
