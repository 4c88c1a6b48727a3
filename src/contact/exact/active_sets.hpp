// Proposes active components for linear complementarity problems, in floating point; the caller checks them.
#pragma once

#include <optional>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// Principal pivoting from a set of active components (Murty 1974; Judice and Pires 1994). While the number of
/// components with the wrong sign decreases, all of them change sides together; if it stalls, only the one with the
/// highest index does. Ends at the solution for a P-matrix. Nothing if a system is singular, or after too many steps.
std::optional<std::vector<bool>> active_by_pivots(const MixedProblem& problem, std::vector<bool> active,
                                                  Effort& effort);

/// Lemke's complementary pivots with the covering vector (1, ..., 1), in a full tableau. For any matrix; nothing if the
/// path does not lead to a solution.
std::optional<std::vector<bool>> active_by_lemke(const MixedProblem& problem, Effort& effort);

}  // namespace slipproof
