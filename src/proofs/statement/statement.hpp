// Statements (proofs/FORMAT.md) as the prover reads them. The prover is not trusted, so this reader may be wrong
// without harm: the checker reads the file itself.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "proofs/statement/formula.hpp"
#include "proofs/statement/statement_text.hpp"

namespace slipproof::prove {

/// numerator / denominator, unreduced, with the divisors that must not vanish, in the order of the text.
struct ValueWithDivisors {
  Polynomial numerator;
  Polynomial denominator;
  std::vector<Polynomial> divisors;
};

class Statement {
 public:
  /// Throws InputError with the mistakes in `text`, the content of the file `name`.
  Statement(const std::string& name, const std::string& text);

  const Ring& ring() const { return *ring_; }
  const StatementText& text() const { return text_; }
  const std::string& theorem() const { return text_.theorem; }
  const std::string& fingerprint() const { return text_.fingerprint; }
  const std::vector<std::pair<std::string, Formula>>& assumptions() const { return assumptions_; }
  /// Variables that the conclusion asks to exist, by index in the ring; the other variables come before them.
  const std::vector<std::size_t>& unknowns() const { return unknowns_; }
  /// The first variable declared after an assumption: from there on variables are unknowns of a motion, before it
  /// parameters.
  std::size_t first_unknown() const { return first_unknown_; }
  /// Polynomials named on lines `# split: EXPRESSION`, worth a case split.
  const std::vector<Polynomial>& hints() const { return hints_; }
  /// The conclusion with values for the unknowns, or, with none, in the unknowns as variables.
  Formula shown(const std::vector<std::string>& witness = {}) const;
  /// The divisors of the values of a witness, in their order.
  std::vector<Polynomial> divisors(const std::vector<std::string>& witness) const;

 private:
  struct Meaning;
  Meaning variables() const;
  Meaning before_unknowns() const;
  std::string file_;
  StatementText text_;
  std::unique_ptr<Ring> ring_;
  std::vector<std::pair<std::string, Formula>> assumptions_;
  std::vector<std::size_t> unknowns_;
  std::size_t first_unknown_ = 0;
  std::vector<Polynomial> hints_;
};

}  // namespace slipproof::prove
