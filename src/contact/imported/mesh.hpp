// Meshes that URDF and SDF name: their convex hulls, by MuJoCo's readers of STL, OBJ and MSH.
#pragma once

#include <filesystem>
#include <string>

#include "contact/imported/scene.hpp"

namespace slipproof::imported {

/// The file that a URI names: `file://`, `model://NAME/...` and `package://NAME/...` are looked for in the folders
/// above the scene's, with NAME and without it. Empty if there is none.
std::filesystem::path find_mesh(const std::string& uri, const std::filesystem::path& scene);

/// Makes the shape a hull. False, with `why`, for what cannot be read.
bool read_hull(const std::filesystem::path& file, const Vector& scale, Shape& shape, std::string& why);

/// Both, for a shape that has its pose and place: false if it has none in the end, with a mistake, or with a note if
/// meshes are left out.
bool read_mesh(const std::string& uri, const Vector& scale, const ReadOptions& options, Shape& shape, Scene& scene,
               Mistakes& mistakes);

}  // namespace slipproof::imported
