// Poisson's law in space: both phases of an impact as one contact problem.
#pragma once

#include <string>
#include <vector>

#include "contact/complete/complete.hpp"
#include "contact/space/solved_space.hpp"

namespace slipproof {

struct PoissonInSpace {
  SolvedSpace space;  ///< motions are outcomes: velocities after, the impulses of both phases, modes in restitution
  std::vector<std::vector<std::string>> compression;  ///< of each motion: the mode of each contact in compression
};

/// All outcomes of a scene whose mechanism is an impact by Poisson's law. Throws as solve_space() does.
///
/// Restitution gives back e N_c at least, and friction is bounded by mu (e N_c + N_b) with the impulse N_b beyond it.
/// So a contact is three that obey Coulomb's law:
///   c  in compression
///   a  with N_a = e N_c always, as its gap is N_a - e N_c; its slip is that after restitution
///   b  with the velocities after restitution, and N_b
/// a and b slip in one direction, with mu N_a + mu N_b; where they stick, their friction has any sum within that. With
/// mu = 0 or e = 0 there is no a. W is not symmetric.
PoissonInSpace solve_poisson_in_space(MechanismScene scene, const CompleteOptions& options = {});

}  // namespace slipproof
