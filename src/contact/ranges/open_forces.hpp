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
  std::size_t contact = 0;     ///< from 0
  double least = 0;            ///< at least 0
  std::optional<double> most;  ///< nothing where no bound was found
};

struct OpenForces {
  double change = 0;  ///< in every component velocities may differ from the answer's by that much
  /// Independent directions in which forces of the largest size change velocities by less than that; as binary64 finds
  /// them.
  std::size_t directions = 0;
  std::vector<NormalRange> ranges;  ///< of the contacts whose force they change, the widest first
  bool all = true;                  ///< otherwise some were left out, which would have been more than the effort
};

/// Of all forces that obey the law with the answer's velocities, where these, and the sums A x + c, may change by
/// `tolerance` of the size of their kind; free unknowns by 10^6 of their sizes. So of every exact solution with these
/// velocities, too. Nothing where no direction is open, for laws other than Coulomb's and the associated one, and
/// beyond `largest_open_part` rows that depend on each other. Takes a rank-revealing decomposition, and two linear
/// programs over cones for each open contact. `x` is finite.
std::optional<OpenForces> open_forces(const MixedProblem& problem, std::span<const double> x, double tolerance,
                                      Effort& effort);
inline constexpr std::size_t largest_open_part = 800;

}  // namespace slipproof
