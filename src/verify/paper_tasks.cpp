#include "verify/paper_tasks.hpp"

#include <string_view>
#include <utility>

namespace slipproof {

namespace {

std::vector<ClaimTask> tasks_of(const ClaimsFile& file, const CompiledClaims& compiled, std::string_view only,
                                LemmaBook& book) {
  std::vector<ClaimTask> tasks;
  for (std::size_t i = 0; i < file.claims.size(); ++i) {
    const Claim& claim = file.claims[i];
    if (!claim.id.starts_with(only)) continue;
    for (const Reading reading : all_readings) {
      if (reading == Reading::repaired && !claim.repaired) continue;
      auto identity = find_identity(file, compiled, i, reading, &book);
      const bool rational = identity || claim.is<Consequence>() || claim.is<System>();
      tasks.push_back({i, reading, std::move(identity), rational});
    }
  }
  return tasks;
}

}  // namespace

PaperTasks::PaperTasks(const ClaimsFile& claims, const VerifyOptions& chosen)
    : file(claims), options(chosen), compiled(claims), all(tasks_of(claims, compiled, chosen.only, book)) {}

}  // namespace slipproof
