// The bodies of a scene in numbers, for physics engines.
#pragma once

#include <string>

#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// One line of JSON, schema `slipproof/bodies/1` (cases/engines/README.md), without a line break: bodies with shapes,
/// state and unknowns, contacts, joints, friction elements, forces and torques, at the scene's values and load. Each
/// number is evaluated exactly and written as the nearest binary64; in the plane boxes become polygons; forces in a
/// body's axes are turned into the scene's, and a reaction is an entry of its own. Throws InputError for a scene of
/// equations, a load without a value, a number that divides by zero or is beyond binary64, and a limit that depends on
/// other forces.
std::string bodies_json(const MechanismScene& scene);

}  // namespace slipproof
