// What an answer's velocities leave open of its forces (contact/MATHEMATICS.md).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// Bounds on the normal force of one contact, proved.
struct NormalRange {
  std::size_t contact = 0;     ///< counted from 0
  double least = 0;            ///< at least 0
  std::optional<double> most;  ///< nothing where no bound was found
};

struct OpenForces {
  double change = 0;  ///< allowed difference of velocities from the answer's in each component
  /// Independent directions in which forces of the largest size change velocities by less than that; as binary64 finds
  /// them.
  std::size_t directions = 0;
  std::vector<NormalRange> ranges;  ///< ranges of the contacts with undetermined forces, widest first
  bool all = true;                  ///< otherwise some were left out, which would have been more than the effort
};

/// Ranges of all forces that obey the law with the answer's velocities. Velocities and the sums A x + c may change by
/// `tolerance` times the size of their kind, free unknowns by 10^6 times theirs, so the ranges contain every exact
/// solution with these velocities. Nothing if all forces are determined, for laws other than Coulomb's and the
/// associated one, and for more than `largest_open_part` coupled rows. Takes a rank-revealing decomposition, and two
/// linear programs over cones for each open contact. `x` is finite.
std::optional<OpenForces> open_forces(const MixedProblem& problem, std::span<const double> x, double tolerance,
                                      Effort& effort);
inline constexpr std::size_t largest_open_part = 800;

}  // namespace slipproof
