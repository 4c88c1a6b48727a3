// Proof that a box around an answer contains no solution: the law of one contact fails everywhere in it.
#pragma once

#include <optional>
#include <span>

#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// A radius within which no solution is, in the maximum norm of all components of x, with the contact or the row whose
/// law fails in all of that box.
struct Exclusion {
  double radius = 0;  ///< a lower bound on the largest such radius; 0 where the answer solves the problem
  std::optional<std::size_t> contact;
  std::size_t row = 0;
};

/// Each row moves by at most the sum of its |a_ij| times the radius, so every condition of a contact has a radius up to
/// which it is certain to fail. A state of the contact (open, stick, slide) fails with one of its conditions, the law
/// with all its states. Linear in the nonzeros of A. `x` is finite, `w` is A x + c.
Exclusion exclusion(const MixedProblem& problem, std::span<const double> x, std::span<const Rational> w);

/// About the same radius with each component over its size: the largest force of x, and of free unknowns what forces of
/// that size give them. In floating point: nothing is proved.
double relative_exclusion(const MixedProblem& problem, std::span<const double> x, std::span<const Rational> w);

}  // namespace slipproof
