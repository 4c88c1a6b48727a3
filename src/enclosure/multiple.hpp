// How many solutions a small problem has: all of its modes, tried exactly.
#pragma once

#include <cstdint>
#include <vector>

#include "enclosure/mixed_problem.hpp"
#include "number/effort.hpp"

namespace slipproof {

struct SolutionCount {
  enum class Kind : std::uint8_t {
    none,
    one,
    several,    ///< finitely many
    continuum,  ///< infinitely many, and maybe single ones besides
    unknown     ///< beyond the effort, or no problem of the kind
  };
  Kind kind = Kind::unknown;
  /// The forces x: of `one` the solution, of `several` all of them, of `continuum` two or more of them.
  std::vector<std::vector<Rational>> solutions;
};

/// Of a problem without free unknowns in dimension 1 or 2. The number of modes is 2^n in n components, each of which
/// takes an elimination: up to a dozen components in a second. Throws NumberError for NaN and infinities.
SolutionCount count_solutions(const MixedProblem& problem, Effort& effort);

}  // namespace slipproof
