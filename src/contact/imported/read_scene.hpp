// Scenes from URDF, SDF and MJCF, by the formats' own parsers (urdfdom, sdformat, MuJoCo), each an optional part of the
// build. Which format it is, the first tag says: robot, sdf or mujoco.
#pragma once

#include <filesystem>

#include "contact/imported/scene.hpp"

namespace slipproof::imported {

/// Reads a scene of bodies; merges bodies that are fixed to each other. Throws InputError for unsupported elements,
/// with name and place.
Scene read_scene_of_bodies(const std::filesystem::path& file, const ReadOptions& options = {});
Scene parse_scene_of_bodies(std::string text, const std::string& file, const ReadOptions& options = {});

}  // namespace slipproof::imported
