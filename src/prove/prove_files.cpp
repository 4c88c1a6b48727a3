#include "prove/prove_files.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "input/diagnostic.hpp"
#include "input/text_file.hpp"
#include "parallel/thread_count.hpp"

namespace slipproof {

std::vector<std::filesystem::path> statements_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> result;
  std::error_code error;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
    if (entry.path().extension() == ".statement") result.push_back(entry.path());
  }
  if (error)
    throw InputError({{folder.string(), 0, 0, "found " + error.message() + ", expected a folder of statements"}});
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<ProofOutcome> prove_files(const std::vector<std::filesystem::path>& statements, unsigned threads) {
  std::vector<ProofOutcome> outcomes(statements.size());
  tbb::task_arena arena(thread_count(threads));
  arena.execute([&] {
    // One statement a task: they differ by orders of magnitude.
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, statements.size(), 1),
        [&](const auto& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) {
            outcomes[i] = prove_statement(statements[i].string(), read_text_file(statements[i]));
          }
        },
        tbb::simple_partitioner());
  });
  return outcomes;
}

}  // namespace slipproof
