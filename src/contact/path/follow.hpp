// Finds a solution of a problem whose equations are too close to dependent for binary64: follows a path of solutions.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/enclosure/mode_system.hpp"

namespace slipproof {

/// Where a path ended: near a solution, to about 30 digits of its equations.
struct PathEnd {
  ConeMode mode;
  std::vector<Rational> x;
  std::vector<Rational> slip;  ///< |u_T| / (mu r_N), of each contact that slides in space; 0 of others
};

/// From the point nearest to `x` that obeys Coulomb's law (contact/MATHEMATICS.md). Nothing if the path leads
/// elsewhere, or meets a border of three modes or more; that proves nothing. Each step solves a system of the size of
/// the mode's in numbers of 106 bits; there are a few for each border that is passed. `x` is finite. Throws
/// TooMuchWork.
std::optional<PathEnd> follow_path(const MixedProblem& problem, std::span<const double> x, Effort& effort);

}  // namespace slipproof
