// The setting of a scene in which one parameter is left free: a line of scenes.
#pragma once

#include <string>

#include "claims/paper/claims_file.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// The setting whose only parameter is `parameter`, which the scene must give; everything else is as in the scene.
/// Throws std::invalid_argument, with a message for people, if the scene has no such parameter.
Setting setting_along(const MechanismScene& scene, const std::string& parameter);

}  // namespace slipproof
