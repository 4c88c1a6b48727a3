// The last step for a claim whose samples and lines are judged: searches for the remaining proofs and counterexamples,
// and sets the verdict.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "claims/judge/tally.hpp"
#include "claims/verify/counterexample.hpp"
#include "claims/verify/paper_tasks.hpp"

namespace slipproof {

/// Results that take long to find, and that ranks send each other.
struct Conclusion {
  bool vacuous = false;  ///< for a claim of existence: the motion exists nowhere
  std::optional<SimplestFailures> failures;
  std::string failure;  ///< why the search failed; empty: nothing went wrong
};

std::string conclusion_bytes(const Conclusion& conclusion);
Conclusion read_conclusion(std::string_view bytes);

/// Whether nothing remains to be found. If certificates decide a claim of existence, no second proof is needed.
bool is_concluded(const PaperTasks& tasks, const ClaimTask& task, const Tally& tally);
Conclusion conclude(const PaperTasks& tasks, const ClaimTask& task, const Tally& tally);
ClaimResult result_of(const PaperTasks& tasks, const ClaimTask& task, const Tally& tally, const Conclusion& conclusion);

}  // namespace slipproof
