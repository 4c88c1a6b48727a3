// The sizes with which errors of an answer are compared: one for forces, one for velocities, one for each row of free
// unknowns.
#pragma once

#include <span>
#include <vector>

#include "contact/enclosure/enclosure.hpp"

namespace slipproof {

/// Sizes of a problem in its own units, from a few sums in floating point: a change of units changes them as it changes
/// the numbers. u = W r + q is what remains when the free unknowns are eliminated, so the local and the global form
/// have the same sizes.
struct ContactSizes {
  double force = 0;     ///< the largest |q_i / W_ii| of a contact's components
  double velocity = 0;  ///< the largest |q_i|
};
ContactSizes contact_sizes(const MixedProblem& problem);

/// Sizes of free unknowns and of their rows, if contact forces are about `force`.
struct FreeSizes {
  std::vector<double> unknowns, rows;
};
FreeSizes free_sizes(const MixedProblem& problem, double force);

/// A number that is known up to a radius.
struct Around {
  Rational center;
  double radius = 0;
};

/// Upper bound on the error of an answer, which is the largest of these:
/// - a force's distance from the solution, over the largest force of the solution, or contact_sizes().force if all are
/// 0;
/// - a velocity's, if `u` is not empty, over the largest velocity of the solution, or without forces if that is larger;
/// - a free unknown's, over what the constants and forces of the largest size give it.
/// Infinite if something differs from 0 and the problem has no size. `x` and `u` are finite.
double error_of(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                const Enclosure& solution);
double error_of(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                const std::vector<Rational>& solution);
/// Of a solution that is somewhere around: all components of x, and of A x + c.
double error_of(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                std::span<const Around> components, std::span<const Around> velocities);

}  // namespace slipproof
