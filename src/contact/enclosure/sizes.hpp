// What errors of an answer are held against: forces, velocities and each row of free unknowns have a size of their own.
#pragma once

#include <span>
#include <vector>

#include "contact/enclosure/enclosure.hpp"

namespace slipproof {

/// Sizes of a problem in its own units, from a few sums in floating point: with the units they change as the numbers
/// do. u = W r + q is what remains when the free unknowns are eliminated, so that the local and the global form have
/// the same sizes.
struct ContactSizes {
  double force = 0;     ///< the largest |q_i / W_ii| of a contact's components
  double velocity = 0;  ///< the largest |q_i|
};
ContactSizes contact_sizes(const MixedProblem& problem);

/// Of free unknowns and their rows, where contact forces are about `force`.
struct FreeSizes {
  std::vector<double> unknowns, rows;
};
FreeSizes free_sizes(const MixedProblem& problem, double force);

/// Upper bound on the error of an answer, which is the largest of these:
/// - a force's distance from the solution, over the largest force of the solution; contact_sizes().force where all are
/// 0;
/// - a velocity's, if `u` is not empty, over the largest velocity of the solution, or without forces if that is larger;
/// - a free unknown's, over what the constants and forces of the largest size give it.
/// Infinite where something differs from 0 and the problem has no size. `x` and `u` are finite.
double error_of(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                const Enclosure& solution);
double error_of(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                const std::vector<Rational>& solution);

}  // namespace slipproof
