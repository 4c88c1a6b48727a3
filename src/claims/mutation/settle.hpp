// Exact arguments for changes of a claims file that no sample tells apart: they say the same, or what is true, too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims/identity/claim_change.hpp"
#include "claims/identity/same_function.hpp"
#include "claims/mutation/claims_mutants.hpp"

namespace slipproof {

/// Settles mutants of one claims file with one reading, with proofs from a book. Not shared between threads.
class Settler {
 public:
  /// What is given must outlive it.
  Settler(const ClaimsFile& file, const CompiledClaims& compiled, LemmaBook& book);

  using Result = std::optional<Settlement>;
  /// `now` is `compiled` with the mutant. Nothing: no argument was found.
  Result settle(const ClaimsMutant& m, const CompiledClaims& now);

  /// A claim about motions, by its index, that is true of all parameters whatever the motion.
  bool is_vacuous(std::size_t claim) const;

 private:
  const Implications& in() const { return logic_[setting_]; }
  Result settle_claim(std::size_t claim, const ClaimBody& before, const ClaimBody& after) const;
  Result settle_definition(const ClaimsMutant& m) const;
  /// What other claims refer to must say the same as before.
  Result accepted(const ClaimsMutant& m, const std::vector<std::size_t>& direct, Result result) const;
  /// An expression with every definition written out that a changed one leads to, and the changed one replaced.
  Expression rewritten(const Expression& e, const std::string& symbol, const Expression& by) const;

  const ClaimsFile& file_;
  const CompiledClaims& compiled_;
  std::vector<Implications> logic_;   ///< by setting
  std::vector<Functions> functions_;  ///< by setting
  std::size_t setting_ = 0;           ///< of the mutant
  const CompiledClaims* changed_ = nullptr;
};

}  // namespace slipproof
