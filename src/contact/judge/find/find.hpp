// Solutions where no answer is given, and others than the one that is.
#pragma once

#include <optional>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/enclosure/enclosure.hpp"

namespace slipproof {

struct FindOptions {
  int rounds = 10;                        ///< of 400 sweeps over all contacts each
  std::size_t largest = 3000;             ///< free unknowns that depend on each other, which are eliminated densely
  std::size_t most_entries = 20'000'000;  ///< largest number of entries of the Delassus matrix
  std::size_t newton = 1000;              ///< components up to which Newton's method is tried, which is cubic
  std::size_t neighbours = 200;           ///< modes that are tried around a solution, as the effort allows
  Work effort = unlimited;                ///< for these
  std::vector<double> start = {};         ///< initial x, of the problem's size; empty: no forces
  bool elsewhere = true;                  ///< small parts that do not converge begin again with other forces
};

/// A start for enclose_solution: by sweeps over the contacts and Newton's method (sweeps.hpp), with the Delassus
/// matrix. Nothing is promised. Empty where the free rows cannot be eliminated or the problem is too large.
std::vector<double> approximate_solution(const MixedProblem& problem, const FindOptions& options = {});

/// The same from forces that press all contacts, harder with each number; empty after the last one. Where forces are
/// redundant, these are others with the same velocities.
std::vector<double> answer_from_elsewhere(const MixedProblem& problem, int number);

/// What this iteration comes to from options.start, if its backward error is within the tolerance.
std::optional<std::vector<double>> converged_answer(const MixedProblem& problem, const FindOptions& options,
                                                    double tolerance);

/// A solution outside the first's box, searched from modes in which one contact differs, and from zero forces. Nothing
/// if none was found, which proves nothing.
std::optional<Enclosure> another_solution(const MixedProblem& problem, const Enclosure& first,
                                          const FindOptions& options = {});

}  // namespace slipproof
