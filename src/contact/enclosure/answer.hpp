// A solver's answer in the problem's own order.
#pragma once

#include <string>
#include <vector>

#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// Free unknowns that solve their rows approximately with the forces of `x`, put into it; false where that breaks down.
/// Cubic in their number where it exceeds a few hundred and A is dense.
bool complete_free_unknowns(const MixedProblem& problem, std::vector<double>& x);

/// An answer as files give it, in one vector; solves for missing free unknowns. `reason` says what is wrong with its
/// size; NaN and infinities are kept.
std::vector<double> answer_vector(const ProblemFile& file, const MixedProblem& problem, const SolverAnswer& answer,
                                  std::string& reason);

}  // namespace slipproof
