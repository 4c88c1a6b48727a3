// Exact arguments for changes of a claims file that no sample notices: the changed file says the same, or something
// else that is also true.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims/identity/claim_change.hpp"
#include "claims/identity/same_function.hpp"
#include "claims/mutation/claims_mutants.hpp"

namespace slipproof {

/// Settles mutants of one claims file in one reading, with proofs from a book. Not shared between threads.
class Settler {
 public:
  /// All arguments must outlive it.
  Settler(const ClaimsFile& file, const CompiledClaims& compiled, LemmaBook& book);

  using Result = std::optional<Settlement>;
  /// `now` is `compiled` with the mutant. Nothing if no argument was found.
  Result settle(const ClaimsMutant& m, const CompiledClaims& now);

  /// Whether a claim about motions, given by its index, is true for all parameters and any motion.
  bool is_vacuous(std::size_t claim) const;

 private:
  const Implications& in() const { return logic_[setting_]; }
  Result settle_claim(std::size_t claim, const ClaimBody& before, const ClaimBody& after) const;
  Result settle_definition(const ClaimsMutant& m) const;
  /// Accepts a result if all that other claims refer to says the same as before.
  Result accepted(const ClaimsMutant& m, const std::vector<std::size_t>& direct, Result result) const;
  /// The expression with all definitions that lead to the changed one written out, and the changed one replaced.
  Expression rewritten(const Expression& e, const std::string& symbol, const Expression& by) const;

  const ClaimsFile& file_;
  const CompiledClaims& compiled_;
  std::vector<Implications> logic_;   ///< by setting
  std::vector<Functions> functions_;  ///< by setting
  std::size_t setting_ = 0;           ///< the mutant's setting
  const CompiledClaims* changed_ = nullptr;
};

}  // namespace slipproof
