// Equations that are exact combinations of others, and the unknowns that are left undetermined with them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "contact/enclosure/mode_system.hpp"

namespace slipproof {

struct DroppedEquation;

/// The equations and unknowns that pivoting in floating point leaves out to make the others regular. It keeps as many
/// equations as unknowns, or `regular` is false.
struct DependentPart {
  std::vector<std::size_t> equations, unknowns;
  bool regular = false;
};

/// Equations that are not linear are kept first. Cubic in their number.
DependentPart dependent_part(const ModeSystem& system, std::span<const double> z,
                             std::span<const std::size_t> equations, std::span<const std::size_t> unknowns);

/// Writes each dropped equation as a combination of the linear ones among `equations` that are kept, coefficient by
/// coefficient and constants included; false if this is impossible for one.
bool combine(const MixedProblem& problem, const ModeSystem& system, std::span<const std::size_t> equations,
             std::vector<DroppedEquation>& dropped);

/// The unknowns to pin and the equations to drop for a regular system; if this cannot be done exactly, `reason` names
/// the unknowns concerned.
struct DependenceResult {
  std::vector<std::size_t> unknowns;
  std::vector<DroppedEquation> dropped;
  std::string reason;
};

/// Rigid bodies on many contacts leave forces undetermined: columns of the derivative depend on each other, and so do
/// its rows, since u = 0 of one contact follows from u = 0 of others. Pivoting in floating point chooses which ones to
/// keep among the `equations` and `unknowns` of a block. A proof that the others follow writes each as a rational
/// combination, coefficient by coefficient and constants included. Up to `largest_dependent` equations that is cubic in
/// the size of the block. Of more, exact rows are eliminated in a sparse order (sparse_basis.hpp), which finds the
/// dependent ones: near linear where bodies touch few others and coordinates are round. A sparse QR decomposition
/// chooses the unknowns then.
DependenceResult exact_dependence(const MixedProblem& problem, const ModeSystem& system, std::span<const double> z,
                                  std::span<const std::size_t> equations, std::span<const std::size_t> unknowns);
inline constexpr std::size_t largest_dependent = 600;

}  // namespace slipproof
