// Bounds on the distance of every solution, for convex laws (contact/MATHEMATICS.md).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/convex/monotone.hpp"
#include "contact/enclosure/residual.hpp"

namespace slipproof {

/// Every solution x has sum_i d_i (x_i - point_i)^2 <= energy^2.
struct EverySolution {
  MonotoneProof proof;
  std::vector<Rational> point, motion;  ///< forces of the convex set, velocities with a finite support there
  std::vector<Rational> velocity;       ///< A point + c
  std::vector<double> shares;           ///< at least |A point + c - motion| / sqrt(d), of each row
  std::vector<double> gaps;             ///< at least what each contact lacks to be complementary
  double energy = 0;
  std::vector<double> radius;   ///< energy / sqrt(d) and above it; infinite where d = 0
  std::vector<double> changes;  ///< the same of A x + c, from A point + c; may be infinite
  double rho = 0;               ///< bound on the distance of the determined components of x from the answer
  double eta = 0;               ///< bound on the distance of A x + c from the answer's
  double apart = 0;             ///< every solution is at least that far from the answer, in a determined component
  std::size_t open = 0;         ///< forces with d = 0: nothing is said of them

  /// There is exactly one: all d are positive.
  bool unique() const { return proof.strict(); }
};

/// Around what `start` is fitted to, and so from `answer`. Nothing where a row with d = 0 cannot be made exact. Both
/// are finite; the problem is convex.
std::optional<EverySolution> every_solution(const MixedProblem& problem, std::span<const double> start,
                                            std::span<const double> answer, MonotoneProof proof);

/// The error of an answer (sizes.hpp) as it follows: every determined component is that near.
double error_of(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                const EverySolution& solution);

}  // namespace slipproof
