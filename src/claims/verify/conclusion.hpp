// What becomes of a claim once its samples and lines are judged: the proofs and counterexamples that are left to find,
// and the verdict.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "claims/judge/tally.hpp"
#include "claims/verify/counterexample.hpp"
#include "claims/verify/paper_tasks.hpp"

namespace slipproof {

/// What takes long to find, and ranks tell each other.
struct Conclusion {
  bool vacuous = false;  ///< or nowhere, of a claim of existence
  std::optional<SimplestFailures> failures;
  std::string failure;  ///< why it could not be found; empty: nothing went wrong
};

std::string conclusion_bytes(const Conclusion& conclusion);
Conclusion read_conclusion(std::string_view bytes);

/// Whether nothing is left to find: what certificates say of existence needs no second proof.
bool is_concluded(const PaperTasks& tasks, const ClaimTask& task, const Tally& tally);
Conclusion conclude(const PaperTasks& tasks, const ClaimTask& task, const Tally& tally);
ClaimResult result_of(const PaperTasks& tasks, const ClaimTask& task, const Tally& tally, const Conclusion& conclusion);

}  // namespace slipproof
