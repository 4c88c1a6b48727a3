#include "claims/verify/paper_tasks.hpp"

#include <string_view>
#include <utility>

#include "base/parallel/failure.hpp"

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
      ClaimTask task{i, reading, {}, false, {}};
      task.failure = failure_of([&] { task.identity = find_identity(file, compiled, i, reading, &book); });
      task.rational = task.identity || claim.kind().is_linear();
      tasks.push_back(std::move(task));
    }
  }
  return tasks;
}

}  // namespace

PaperTasks::PaperTasks(const ClaimsFile& claims, const VerifyOptions& chosen)
    : file(claims), options(chosen), compiled(claims), all(tasks_of(claims, compiled, chosen.only, book)) {}

}  // namespace slipproof
