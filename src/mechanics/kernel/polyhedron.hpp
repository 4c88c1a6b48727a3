// The solutions of linear equations that meet conditions, for one load or for all.
//
// Decides whether there is a solution, whether one meets all conditions strictly, and for which loads. If the equations
// leave an unknown free, a linear program maximises s under conditions >= s. s > 0 gives a strict solution; for s < 0
// the multipliers show which conditions exclude each other; for s = 0 they show which conditions vanish on all
// solutions. Those become equations; the remaining system has a strict solution, and the dimension of its solutions is
// that of its space.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "mechanics/kernel/affine_space.hpp"

namespace slipproof {

/// Solutions, at least one.
struct Polyhedron {
  AffineSpace space;              ///< the least that contains all of them
  std::vector<AffineForm> sides;  ///< on the space: the conditions that are neither always 0 nor always positive
  bool strict = false;            ///< some solution meets all of the conditions strictly
  ForceInterval loads;            ///< loads with a solution
};

/// There is no solution.
struct Conflict {
  /// Conditions, by index, that exclude each other for loads of the domain. None: the space has no load of the domain.
  std::vector<std::size_t> conditions;
  std::optional<Rational> margin;  ///< negative value of a condition, if it is the same for all solutions
};

using Narrowed = std::variant<Polyhedron, Conflict>;

/// The solutions in a space that meet the conditions at some load of the domain. Linear programs are charged to an
/// effort; throws TooMuchWork beyond it. `on_space` are the conditions on the space, where they are known, times
/// positive numbers where they vary.
Narrowed narrow(AffineSpace space, const std::vector<AffineForm>& conditions, const ForceInterval& domain,
                Effort* effort = nullptr, std::vector<AffineForm> on_space = {});

/// Why there is no solution, computed faster: may also return nothing if all that is left is an end that the domain
/// does not have.
std::optional<Conflict> find_conflict(const AffineSpace& space, const std::vector<AffineForm>& conditions,
                                      const ForceInterval& domain, Effort* effort = nullptr);

/// The same solutions at one load.
std::optional<Polyhedron> at_load(const Polyhedron& solutions, const Rational& load);

/// Whether some solution at a load meets all conditions strictly; there must be one at that load.
bool strict_at(const Polyhedron& solutions, const Rational& load);

/// The loads for which some solution meets all conditions strictly: all, or all but ends.
ForceInterval strict_loads(const Polyhedron& solutions);

/// The solutions with form = 0.
std::optional<Polyhedron> restrict_to_zeros(const Polyhedron& solutions, const std::vector<AffineForm>& vanishing,
                                            Effort* effort = nullptr);

/// Infimum and supremum; nothing if infinite.
struct Range {
  std::optional<Rational> lower, upper;
  bool is_point() const { return lower && upper && *lower == *upper; }
  bool operator==(const Range&) const = default;
};
/// Range of each form over the solution set.
std::vector<Range> ranges(const Polyhedron& solutions, const std::vector<AffineForm>& forms);

}  // namespace slipproof
