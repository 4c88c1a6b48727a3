// An exact solution where the forces depend on each other up to rounding.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/enclosure/enclosure.hpp"

namespace slipproof {

/// A solution by Coulomb's law that a path leads to from `x` (contact/MATHEMATICS.md), enclosed in long numbers. Parts
/// of the problem that share no row are solved one by one, in binary64 where that is enough. Its forces may be far from
/// those of `x` where rounding determines them; its velocities are near. Nothing if none was found, which proves
/// nothing. `x` is finite. Throws TooMuchWork; parts have up to `largest_on_path` rows.
std::optional<Enclosure> solve_along_path(const MixedProblem& problem, std::span<const double> x, Effort& effort);
inline constexpr std::size_t largest_on_path = 800;

/// Upper bound on the distance of the velocities of such a solution from those of an answer's forces, A x + c.
double velocity_distance(const MixedProblem& problem, const Enclosure& solution, std::span<const double> x);
/// How far each contact's force is from that of the enclosed solution, in its largest component.
std::vector<double> force_distances(const MixedProblem& problem, const Enclosure& solution, std::span<const double> x);

}  // namespace slipproof
