// One parameter of a scene left free, as the setting of a claims file has it: the line of scenes through it.
#pragma once

#include <string>

#include "claims/paper/claims_file.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// The setting whose only parameter is `parameter`, which the scene gives; all else is as in the scene. Throws
/// std::invalid_argument, with a message for people, for what is no parameter of the scene.
Setting setting_along(const MechanismScene& scene, const std::string& parameter);

}  // namespace slipproof
