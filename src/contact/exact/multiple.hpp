// Counts the solutions of a small problem: tries all of its modes exactly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/enclosure/mixed_problem.hpp"

namespace slipproof {

struct SolutionCount {
  enum class Kind : std::uint8_t {
    none,
    one,
    several,    ///< finitely many
    continuum,  ///< infinitely many, and maybe isolated ones, too
    unknown     ///< beyond the effort, or no problem of the kind
  };
  Kind kind = Kind::unknown;
  /// x: of `one` the solution, of `several` all of them, of `continuum` two or more of them, with those of its members
  /// that are nearest to the forces of an answer.
  std::vector<std::vector<Rational>> solutions;
};

/// For a problem in dimension 1 or 2 whose free unknowns can be eliminated. There are 2^n modes in n components, and
/// each takes an elimination: up to a dozen components in a second. `answer` is empty, or a finite x. Throws
/// NumberError for NaN and infinities.
SolutionCount count_solutions(const MixedProblem& problem, Effort& effort, std::span<const double> answer = {});

/// Free unknowns that count_solutions() eliminates.
inline constexpr std::size_t max_eliminated = 200;

}  // namespace slipproof
