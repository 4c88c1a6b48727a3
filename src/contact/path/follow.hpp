// Finds a solution of a problem whose equations are too close to dependent for binary64: follows a path of solutions.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/enclosure/mode_system.hpp"

namespace slipproof {

/// The end of a path: a point that solves its equations to about 30 digits.
struct PathEnd {
  ConeMode mode;
  std::vector<Rational> x;
  std::vector<Rational> slip;  ///< |u_T| / (mu r_N), of each contact that slides in space; 0 of others
};

/// Follows the path from the point nearest to `x` that obeys Coulomb's law (contact/MATHEMATICS.md). Nothing if the
/// path leads elsewhere, or meets a boundary of three or more modes; that proves nothing. Each step solves a system of
/// the size of the mode's in numbers of 106 bits; each boundary takes a few steps. `x` is finite. Throws TooMuchWork.
std::optional<PathEnd> follow_path(const MixedProblem& problem, std::span<const double> x, Effort& effort);

}  // namespace slipproof
