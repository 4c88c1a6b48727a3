// A scene file, and what uniqueness along a parameter says of it.
#pragma once

#include <filesystem>
#include <string>

#include "claims/uniqueness/along.hpp"

namespace slipproof {

struct SceneAlong {
  MechanismScene scene;
  UniquenessAlong along;
};

/// Of a scene file of a bicycle or of a mechanism. No parameter: the usual one, f of a bicycle or a mechanism's first
/// coefficient of friction. Throws InputError, also for what is no parameter of the scene, and for a scene without
/// values.
SceneAlong read_scene_along(const std::filesystem::path& file, const std::string& parameter = "");

}  // namespace slipproof
