// A scene file and its uniqueness along a parameter.
#pragma once

#include <filesystem>
#include <string>

#include "claims/uniqueness/along.hpp"

namespace slipproof {

struct SceneAlong {
  MechanismScene scene;
  UniquenessAlong along;
};

/// Reads a scene file of a bicycle or of a mechanism. Without a parameter, takes the usual one: f of a bicycle, or a
/// mechanism's first coefficient of friction. Throws InputError, also if the scene has no such parameter, or has no
/// values.
SceneAlong read_scene_along(const std::filesystem::path& file, const std::string& parameter = "");

}  // namespace slipproof
