// Finds all motions of a scene in space.
#pragma once

#include "contact/complete/complete.hpp"
#include "contact/space/solved_space.hpp"

namespace slipproof {

/// At the scene's load. Throws InputError as space_problem() and reduced() do, and std::runtime_error in a build
/// without Clp.
SolvedSpace solve_space(MechanismScene scene, const CompleteOptions& options = {});

}  // namespace slipproof
