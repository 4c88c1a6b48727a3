// Finds all motions of a scene in space.
#pragma once

#include "contact/complete/complete.hpp"
#include "contact/judge/all_solutions.hpp"
#include "contact/space/solved_space.hpp"
#include "contact/space/space_problem.hpp"

namespace slipproof {

/// At the scene's load. Throws InputError as space_problem() and reduced() do, and std::runtime_error in a build
/// without Clp.
SolvedSpace solve_space(MechanismScene scene, const CompleteOptions& options = {});

/// Reads solutions of the scene's contact problem, u = W r + q of `free`, as motions.
SolvedSpace read_motions(MechanismScene scene, const SpaceProblem& problem, const ReducedSpace& free,
                         const AllSolutions& all);

}  // namespace slipproof
