// The velocities of all bodies of a linkage from a few numbers: [state] of a mechanism file.
#pragma once

#include <vector>

#include "mechanics/bodies/derive.hpp"

namespace slipproof {

/// Fills in `velocity` and `spin` of the bodies of each linkage of which [state] says something; other bodies keep
/// theirs. They follow, as quotients of polynomials, from what the joints, guides and gears hold, from [state], from
/// the velocities that bodies have in the file, and from contacts with a given state: these stay closed, and one that
/// rests does not slide; in this order, where an equation that follows from those before is compared with them. Reports
/// the freedoms that are left. Returns what must hold: that given numbers agree, and that the velocities are
/// determined, which is not so at a dead centre.
std::vector<GeometryFact> find_velocities(Bodies& bodies, const Mechanism& mechanism, Mistakes& mistakes);

}  // namespace slipproof
