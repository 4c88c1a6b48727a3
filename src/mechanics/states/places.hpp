// Bodies that a joint places: where they are, and how they are turned.
#pragma once

#include "mechanics/bodies/bodies.hpp"

namespace slipproof {

/// Fills in `at` and `rotation` of bodies that a joint places (Body::by), one after the other along chains, and the
/// contacts in place of joints with friction. Reports joints that place nothing, and bodies that place each other.
void place_bodies(Bodies& bodies, const Mechanism& mechanism, Mistakes& mistakes);

}  // namespace slipproof
