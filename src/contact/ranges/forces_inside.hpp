// Forces moved inside of their cones, with the velocities as they are.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/enclosure/mode_system.hpp"

namespace slipproof {

/// A point near an answer, and the mode that the answer's velocities say: a contact that they do not move sticks.
struct InsideForces {
  std::vector<double> x;
  ConeMode mode;
};

/// Moves the forces of an answer inside of what Coulomb's law allows at its velocities, along directions that change
/// velocities by less than `tolerance` of their size: each r_N is `margin` times the largest force at least, and r_T as
/// far from its limit. Nothing where there are no such forces, or none are found; nothing is proved. If `toward` is
/// given, the forces are within `contact_near` of those of that point, with the velocities of x. Takes a sparse
/// factorization for each part, and up to thousands of solutions with it. `x` is finite. Throws TooMuchWork.
std::optional<InsideForces> forces_inside(const MixedProblem& problem, std::span<const double> x, double tolerance,
                                          double margin, Effort& effort, std::span<const double> toward = {});

}  // namespace slipproof
