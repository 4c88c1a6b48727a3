// A scene whose bodies move with given velocities, to be drawn.
#pragma once

#include <string>
#include <vector>

#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// The velocities and spins of bodies, by the names of their unknown accelerations; others stay. As it is for a
/// mechanism by equations.
MechanismScene moving_scene(MechanismScene scene, const std::vector<std::string>& unknowns,
                            const std::vector<Rational>& velocities);

}  // namespace slipproof
