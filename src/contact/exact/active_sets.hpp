// Proposals of active components for linear complementarity problems, in floating point: whoever uses them checks them.
#pragma once

#include <optional>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/enclosure/mixed_problem.hpp"

namespace slipproof {

/// From a set of active components, by principal pivoting: all components of the wrong sign change sides at once while
/// their number falls, and one at a time, that of the highest index, where it does not for long (Murty 1974; Judice and
/// Pires 1994). For a P-matrix this ends at the solution. Nothing where a system is singular, or it takes too long.
std::optional<std::vector<bool>> active_by_pivots(const MixedProblem& problem, std::vector<bool> active,
                                                  Effort& effort);

/// By Lemke's complementary pivots with the covering vector (1, ..., 1), in a full tableau: for any matrix, as far as
/// the path leads to a solution.
std::optional<std::vector<bool>> active_by_lemke(const MixedProblem& problem, Effort& effort);

}  // namespace slipproof
