// Robots that stand on the ground.
#pragma once

#include "contact/imported/scene.hpp"

namespace slipproof::imported {

/// Moves all bodies that no joint connects to the ground, tree by tree, along z until the lowest of their shapes
/// touches a plane of the ground. Adds a note for each tree that moved.
void stand_on_ground(Scene& scene);

}  // namespace slipproof::imported
