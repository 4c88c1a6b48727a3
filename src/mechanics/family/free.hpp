// Scenes in which a symbol is freed.
#pragma once

#include <string>

#include "mechanics/family/family.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// The family in which one parameter, which the scene must give, is free under every load; everything else is as in the
/// scene. Throws std::invalid_argument, with a message for people, if the scene has no such parameter.
Family with_free(const MechanismScene& scene, const std::string& parameter);

}  // namespace slipproof
