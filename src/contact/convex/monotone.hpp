// Laws that are convex, which Coulomb's is not, and matrices by which they have one solution.
#pragma once

#include <optional>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// True if the law of each contact has the form: r in a convex set, -u in its normal cone at r. So for the associated
/// law, fixed bounds, and any law without friction.
bool is_convex(const MixedProblem& problem);

/// Why x . A x >= sum_i d_i x_i^2 for all x.
struct MonotoneProof {
  std::vector<Rational> moduli;  ///< d_i >= 0 of each row
  /// L, no entry above its diagonal. In each row of A + A^T - 2 D - L L^T the diagonal entry is at least the sum of the
  /// absolute values of the others: it is semidefinite (Gershgorin).
  SparseMatrix factor;

  /// Whether all d_i are positive.
  bool strict() const;
};

/// Such a proof with large moduli, in proportion to the diagonal of A in each connected part of its symmetric one;
/// nothing where none was found. An eigenvalue problem of each part up to 1500 rows, and its factorisation, in the
/// effort. Throws TooMuchWork.
std::optional<MonotoneProof> prove_monotone(const MixedProblem& problem, Effort& effort);

}  // namespace slipproof
