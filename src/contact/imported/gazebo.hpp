// The models that nearly every world of Gazebo includes, which are known without a file.
#pragma once

#include "contact/imported/scene.hpp"
#include "contact/imported/tags.hpp"

namespace slipproof::imported {

/// Takes the sun and the ground plane out of the document of a world; other included models are mistakes. Whether there
/// was the plane.
bool take_known_includes(TaggedFile& file, Mistakes& mistakes);

/// Adds Gazebo's ground plane: level, at height 0, mu 100 and mu2 50.
void add_ground_plane(Scene& scene);

}  // namespace slipproof::imported
