// Sweeps over contacts: an answer in binary64 where none is given.
#pragma once

#include <vector>

#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// Solves each contact for itself, with the forces of the others as they are, until all agree: projected Gauss-Seidel
/// iteration, as NSGS does it. One contact is solved exactly by Coulomb's law (lift, stick, or a slip whose direction
/// is a root in one angle), by iteration under the associated law and fixed bounds. Sweeps converge slowly where forces
/// are redundant, so a point is extrapolated from the last few of them (Anderson's acceleration), which is begun again
/// where sweeps alone would do better; and after each of the first rounds of 400 sweeps Newton's method is tried
/// (contact_newton.hpp), for up to `newton` components. Nothing is promised of the result, which may be not finite.
///
/// `problem` has no free unknowns; `r` is the start. Ends after so many rounds, or when all contacts agree up to
/// rounding. A sweep is linear in the entries of A.
struct SweptForces {
  std::vector<double> r;
  bool agreed = false;
};
SweptForces swept(const MixedProblem& problem, const std::vector<double>& r, int rounds, std::size_t newton);

}  // namespace slipproof
