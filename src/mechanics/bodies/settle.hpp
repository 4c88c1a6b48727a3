// Holds a scene of bodies to itself, and finds how its contacts and friction elements move before the motion.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/bodies/derive.hpp"

namespace slipproof {

/// Facts that are no identities are tried at points of the domain: one that fails there is reported, with the values
/// and by how much; the others become assumptions of the mechanism, so that no scene breaks them unnoticed. States of
/// motion follow from velocities in the same way: where the sign of one depends on parameters, it becomes an
/// assumption, too. For a mechanism whose forms are derived.
void settle_geometry(const BodyGeometry& geometry, Mechanism& mechanism, Mistakes& mistakes);

/// The same before an impact, where closed contacts may approach and open, and no state follows from velocities. Of
/// each contact: -1, 0 or +1 as it approaches, rests or opens at all points; nothing where that depends on the point.
/// With `by_sign` what is found becomes an assumption.
std::vector<std::optional<int>> settle_before_impact(const BodyGeometry& geometry, Mechanism& mechanism,
                                                     Mistakes& mistakes, bool by_sign);

}  // namespace slipproof
