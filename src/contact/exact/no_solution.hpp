// Problems that no forces solve at all: multipliers that show it.
#pragma once

#include <optional>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// Multipliers y for the rows of A x + c, with which every x in the cones would have y . (A x + c) <= c . y < 0, where
/// u_N >= 0 needs it to be >= 0: y_i >= 0 in normal rows and 0 in tangential ones; g = A^T y is 0 for free unknowns,
/// and for each contact g_N <= 0 and mu^2 |g_T|^2 <= g_N^2. Decided exactly; false where the size is another. Like
/// infeasibility() it throws NumberError for problems with NaN and infinities.
bool shows_no_solution(const std::vector<Rational>& y, const MixedProblem& problem);

/// Such multipliers, checked; nothing if there are none, or none were found within the effort. Solves linear programs
/// in exact numbers, first with the problem's numbers cut short: milliseconds for most problems of 60 components, up to
/// a minute for hard ones. In dimension 3 each cone is replaced by an inscribed pyramid of 8 or 24 sides, so
/// multipliers that need the last hundredth of its width are missed.
std::optional<std::vector<Rational>> infeasibility(const MixedProblem& problem, Effort& effort);

}  // namespace slipproof
