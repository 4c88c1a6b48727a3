// An exact solution where the forces depend on each other up to rounding.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/enclosure/enclosure.hpp"

namespace slipproof {

/// An answer to a problem, for 0, 1, ...; empty if there is none.
using OtherAnswers = std::function<std::vector<double>(const MixedProblem& problem, int number)>;

/// Finds a solution under Coulomb's law by following a path from `x` (contact/MATHEMATICS.md), and encloses it in long
/// numbers. Solves parts of the problem that share no row separately, in binary64 if that suffices. The forces may be
/// far from those of `x` if rounding determines them; the velocities are near. Nothing if none was found, which proves
/// nothing. At `x`, which is finite, enclose_solution() has found none. Throws TooMuchWork; parts have up to
/// `largest_on_path` rows. Where no path leads from x to a solution of a part, others are tried, from answers of
/// `elsewhere` that have the same velocities.
std::optional<Enclosure> solve_along_path(const MixedProblem& problem, std::span<const double> x, Effort& effort,
                                          const OtherAnswers& elsewhere = {});
inline constexpr std::size_t largest_on_path = 800;

/// Upper bound on the distance of the velocities of such a solution from those of an answer's forces, A x + c.
double velocity_distance(const MixedProblem& problem, const Enclosure& solution, std::span<const double> x);
/// For each contact, the largest distance in a component of its force from that of the enclosed solution.
std::vector<double> force_distances(const MixedProblem& problem, const Enclosure& solution, std::span<const double> x);

}  // namespace slipproof
