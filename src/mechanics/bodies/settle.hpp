// Holds a scene of bodies to itself, and finds how its contacts and friction elements move before the motion.
#pragma once

#include "mechanics/bodies/derive.hpp"

namespace slipproof {

/// Facts that are no identities are tried at points of the domain: one that fails there is reported, with the values
/// and by how much; the others become assumptions of the mechanism, so that no scene breaks them unnoticed. States of
/// motion follow from velocities in the same way: where the sign of one depends on parameters, it becomes an
/// assumption, too. For a mechanism whose forms are derived.
void settle_geometry(const BodyGeometry& geometry, Mechanism& mechanism, Mistakes& mistakes);

}  // namespace slipproof
