// Which lines the claims of a paper are judged along, once the samples are.
#pragma once

#include <cstdint>
#include <vector>

#include "claims/judge/tally.hpp"
#include "claims/lines/line.hpp"
#include "claims/verify/paper_tasks.hpp"

namespace slipproof {

/// The lines of a task, and what choosing them needs.
struct TaskLines {
  std::size_t task;                          ///< index
  std::vector<bool> matters;                 ///< by parameter
  std::vector<std::vector<Rational>> bases;  ///< bicycles that the lines go through, one at least
  std::uint64_t count;

  /// Number k of them.
  Line line(std::uint64_t k, std::uint64_t seed) const { return line_number(k, seed + task, bases, matters); }
};

/// Of all tasks that want lines, setting by setting; `tallies` are of the samples, by task; they
/// keep why there are no lines of one.
std::vector<TaskLines> lines_of_tasks(const PaperTasks& tasks, std::vector<Tally>& tallies);

}  // namespace slipproof
