// Scenes from URDF, SDF and MJCF, by the formats' own parsers (urdfdom, sdformat, MuJoCo), each an optional part of the
// build. Which format it is, the first tag says: robot, sdf or mujoco.
#pragma once

#include <filesystem>

#include "contact/imported/scene.hpp"
#include "contact/imported/tags.hpp"

namespace slipproof::imported {

/// Bodies that are fixed to each other are one. Throws InputError for what is not read, with name and place.
Scene read_scene_of_bodies(const std::filesystem::path& file);
Scene parse_scene_of_bodies(std::string text, const std::string& file);

/// Of one format each. Where its parser is not built in, a mistake that says so.
void read_urdf(TaggedFile& file, Scene& scene, Mistakes& mistakes);
void read_sdf(TaggedFile& file, Scene& scene, Mistakes& mistakes);
void read_mjcf(TaggedFile& file, Scene& scene, Mistakes& mistakes);

/// What the readers share: the turn, told where it is not the file's.
Turn turn_of(const std::array<double, 4>& quaternion, const std::string& whose, Scene& scene);

}  // namespace slipproof::imported
