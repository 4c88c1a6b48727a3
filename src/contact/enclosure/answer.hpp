// A solver's answer in the problem's own order.
#pragma once

#include <string>
#include <vector>

#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// Solves the free rows approximately for the free unknowns, given the forces in `x`, and stores them there. Returns
/// false if the elimination breaks down. Cubic in their number if that exceeds a few hundred and A is dense.
bool complete_free_unknowns(const MixedProblem& problem, std::vector<double>& x);

/// Converts an answer from a file to one vector; solves for missing free unknowns. Sets `reason` if its size is wrong.
/// Keeps NaN and infinities.
std::vector<double> answer_vector(const ProblemFile& file, const MixedProblem& problem, const SolverAnswer& answer,
                                  std::string& reason);

}  // namespace slipproof
