// The solution of a linear complementarity problem as exact numbers, at sizes of a thousand.
#pragma once

#include <optional>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/linear/exact_system.hpp"
#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// x >= 0, w = A x + c >= 0, and x_i w_i = 0.
struct ExactLcpSolution {
  std::vector<bool> active;  ///< true: solved with w_i = 0; false: with x_i = 0
  ExactVector x, w;

  /// 1: x_i > 0, -1: w_i > 0, 0: both are 0, and the set of active components is not the only one.
  int state(std::size_t i) const { return x.sign(i) - w.sign(i); }
};

/// A solution of a complementarity problem, from a proposal of its active components: those where x_i > 0. Floating
/// point improves the proposal by principal pivoting, and proposes another by Lemke's method. The solution itself and
/// all its signs are computed without rounding. If a sign is still wrong, a few more pivots follow the exact signs,
/// each with a new solution. Other solutions may exist: unique_class.hpp excludes them. Nothing if none was found
/// within the effort, or if the problem is not a complementarity problem. See exact_solution() for the cost.
std::optional<ExactLcpSolution> solve_lcp(const MixedProblem& problem, std::vector<bool> active, Effort& effort);

/// The solution with these active components; nothing unless there is exactly one. Throws TooMuchWork.
std::optional<ExactLcpSolution> solve_active(const MixedProblem& problem, const std::vector<bool>& active,
                                             Effort& effort);

}  // namespace slipproof
