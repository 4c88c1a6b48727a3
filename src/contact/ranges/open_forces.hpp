// What an answer's velocities leave open of its forces (contact/MATHEMATICS.md).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/enclosure/mode_system.hpp"

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

/// A point near an answer, and the mode that the answer's velocities say: a contact that they do not move sticks.
struct InsideForces {
  std::vector<double> x;
  ConeMode mode;
};

/// Moves the forces of an answer inside of what Coulomb's law allows at its velocities, along directions that change
/// velocities by less than `tolerance` of their size: each r_N is `margin` times the largest force at least, and r_T as
/// far from its limit. Nothing where there are no such forces, or none are found; nothing is proved. Parts have up to
/// `largest_open_part` rows. `x` is finite. Throws TooMuchWork.
std::optional<InsideForces> forces_inside(const MixedProblem& problem, std::span<const double> x, double tolerance,
                                          double margin, Effort& effort);

}  // namespace slipproof
