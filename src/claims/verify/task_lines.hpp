// Chooses the lines along which the claims of a paper are judged, after the samples.
#pragma once

#include <cstdint>
#include <vector>

#include "claims/judge/tally.hpp"
#include "claims/verify/paper_tasks.hpp"
#include "mechanics/lines/line.hpp"

namespace slipproof {

/// The lines of a task, and the data for choosing them.
struct TaskLines {
  std::size_t task;                          ///< index
  std::vector<bool> matters;                 ///< by parameter
  std::vector<std::vector<Rational>> bases;  ///< bicycles that the lines go through, at least one
  std::uint64_t count;

  /// Line number k of the task.
  Line line(std::uint64_t k, std::uint64_t seed) const { return line_number(k, seed + task, bases, matters); }
};

/// The lines of all tasks that want lines, setting by setting. `tallies` are those of the samples, by task; if lines of
/// a task cannot be chosen, its tally gets the reason.
std::vector<TaskLines> lines_of_tasks(const PaperTasks& tasks, std::vector<Tally>& tallies);

}  // namespace slipproof
