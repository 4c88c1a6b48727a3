// All motions of a scene.
#pragma once

#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/solved_mechanism.hpp"

namespace slipproof {

/// Finds all modes. If there are too many to try, or if only motions are requested, finds all motions by kinematics
/// (kinematic_modes.hpp). Throws InputError if that takes more than some seconds, or if a coefficient has no value.
SolvedMechanism solve_mechanism(MechanismScene scene, Listing listing = Listing::modes);

}  // namespace slipproof
