// Proposes active components for linear complementarity problems, in floating point; the caller checks them.
#pragma once

#include <optional>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// Principal pivoting from a set of active components: all components of the wrong sign change sides at once while
/// their number falls; if it does not fall for long, one at a time, that of the highest index (Murty 1974; Judice and
/// Pires 1994). For a P-matrix this ends at the solution. Nothing if a system is singular, or it takes too long.
std::optional<std::vector<bool>> active_by_pivots(const MixedProblem& problem, std::vector<bool> active,
                                                  Effort& effort);

/// Lemke's complementary pivots with the covering vector (1, ..., 1), in a full tableau. For any matrix; nothing if the
/// path does not lead to a solution.
std::optional<std::vector<bool>> active_by_lemke(const MixedProblem& problem, Effort& effort);

}  // namespace slipproof
