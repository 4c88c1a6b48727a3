// Equations that are exact combinations of others, and the unknowns that are left undetermined with them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "contact/enclosure/mode_system.hpp"

namespace slipproof {

struct DroppedEquation;

/// What pivoting in floating point leaves out of some equations and some of their unknowns, to make them regular. As
/// many are kept of one as of the other, or `regular` is false.
struct DependentPart {
  std::vector<std::size_t> equations, unknowns;
  bool regular = false;
};

/// Equations that are not linear are kept first. Cubic in their number.
DependentPart dependent_part(const ModeSystem& system, std::span<const double> z,
                             std::span<const std::size_t> equations, std::span<const std::size_t> unknowns);

/// What has to be pinned and dropped for a regular system; `reason` where that cannot be done exactly, with the
/// unknowns that it is about.
struct DependenceResult {
  std::vector<std::size_t> unknowns;
  std::vector<DroppedEquation> dropped;
  std::string reason;
};

/// Rigid bodies on many contacts leave forces undetermined: columns of the derivative depend on each other, and so do
/// its rows, u = 0 of one contact following from u = 0 of others. Which ones to keep is chosen in floating point by
/// pivoting; that the others follow is proved by writing each as a rational combination, coefficient by coefficient and
/// constants included. Cubic in the size of the system, for systems up to `largest_dependent`.
DependenceResult exact_dependence(const MixedProblem& problem, const ModeSystem& system, std::span<const double> z);
inline constexpr std::size_t largest_dependent = 600;

}  // namespace slipproof
