// A phase diagram of a scene as JSON.
#pragma once

#include <string>

#include "mechanics/planes/phase_diagram.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// One JSON document, schema slipproof/map/2: every column with its exact intervals of the load, in space
/// with its places.
std::string map_json(const PhaseDiagram& diagram, const MechanismScene& scene);

}  // namespace slipproof
