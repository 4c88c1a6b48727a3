// Proofs for all parameters: from a statement to a certificate. Nothing here is trusted; check/ judges what comes out.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/statement/limits.hpp"
#include "proofs/statement/refutation_text.hpp"

namespace slipproof {

/// The outcome of a search for a proof.
struct ProofOutcome {
  enum class Verdict : std::uint8_t {
    proved,
    refuted,   ///< it is false at `counterexample`
    undecided  ///< the search ended without either
  };

  std::string theorem;
  Verdict verdict = Verdict::undecided;
  std::string certificate;  ///< its text, where it is proved
  /// True if it is proved because its assumptions contradict each other, although the conclusion is not `false`.
  bool vacuous = false;
  NamedValues counterexample;         ///< values that meet the assumptions, and at which the conclusion is false
  std::vector<std::string> leftover;  ///< if undecided: the sign conditions that the search could not refute
  bool exhausted = false;             ///< if undecided: more steps might suffice
  std::uint64_t steps = 0;            ///< steps of the search for a proof

  bool proved() const { return verdict == Verdict::proved; }
};
std::string_view name(ProofOutcome::Verdict verdict);

/// Searches for numbers at which the statement in `text`, the content of `file`, is false, and for a proof.
/// Deterministic. Throws InputError.
ProofOutcome prove_statement(const std::string& file, const std::string& text, const prove::Limits& limits = {});

/// Searches for a proof that a formula such as `x^2 + y^2 >= 2*x*y` holds for all real values of its variables (see
/// formula_statement()). Mistakes are reported with columns in the formula.
ProofOutcome prove_formula(const std::string& formula, const prove::Limits& limits = {});

/// Whether a certificate never uses the conclusion of its statement, and so shows that the assumptions contradict each
/// other.
bool uses_assumptions_only(std::string_view certificate);

/// Whether the statement says just that: that its assumptions contradict each other. Throws InputError.
bool claims_contradiction(const std::string& file, const std::string& text);

}  // namespace slipproof
