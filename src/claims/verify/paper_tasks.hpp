// The tasks of verify() for a paper: each claim in each reading, with what is known before any sample.
#pragma once

#include <optional>
#include <vector>

#include "claims/identity/identity.hpp"
#include "claims/identity/lemmas.hpp"
#include "claims/paper/compiled.hpp"
#include "claims/verify/verify.hpp"

namespace slipproof {

/// One claim in one reading.
struct ClaimTask {
  std::size_t claim;  ///< index in the file
  Reading reading;
  std::optional<Identity> identity;
  bool rational;        ///< it is true or false as a statement about rational functions; if false, it is false nearly
                        ///< everywhere
  std::string failure;  ///< of the search for an identity; empty: nothing went wrong
};

/// The tasks of a paper, and the data that they share. May be used by several threads.
struct PaperTasks {
  /// All arguments must outlive it.
  PaperTasks(const ClaimsFile& claims, const VerifyOptions& chosen);

  const Claim& claim_of(const ClaimTask& task) const { return file.claims[task.claim]; }
  const CompiledSetting& setting_of(const ClaimTask& task) const { return compiled.settings[claim_of(task).setting]; }

  const ClaimsFile& file;
  const VerifyOptions& options;
  const CompiledClaims compiled;
  /// For short proofs only; samples examine the rest.
  mutable LemmaBook book{
      {.split_depth = 1, .slack_attempts = 100, .products = 0, .quick_samples = 0, .samples = 0, .steps = 2'000'000}};
  const std::vector<ClaimTask> all;
};

}  // namespace slipproof
