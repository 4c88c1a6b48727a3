// The readers of the formats, which the module has.
#pragma once

#include <array>
#include <string>

#include "contact/imported/scene.hpp"
#include "contact/imported/tags.hpp"

namespace slipproof::imported {

/// Of one format each. Where its parser is not built in, a mistake that says so.
void read_urdf(TaggedFile& file, Scene& scene, Mistakes& mistakes);
void read_sdf(TaggedFile& file, Scene& scene, Mistakes& mistakes);
void read_mjcf(TaggedFile& file, Scene& scene, Mistakes& mistakes);

/// The turn, told where it is not the file's.
Turn turn_of(const std::array<double, 4>& quaternion, const std::string& whose, Scene& scene);

}  // namespace slipproof::imported
