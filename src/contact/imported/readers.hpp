// The readers of the formats, which the module has.
#pragma once

#include <array>
#include <string>

#include "contact/imported/scene.hpp"
#include "contact/imported/tags.hpp"

namespace slipproof::imported {

/// Readers, one for each format. Report a mistake if the parser of the format is not built in.
void read_urdf(TaggedFile& file, const ReadOptions& options, Scene& scene, Mistakes& mistakes);
void read_sdf(TaggedFile& file, const ReadOptions& options, Scene& scene, Mistakes& mistakes);
void read_mjcf(TaggedFile& file, const ReadOptions& options, Scene& scene, Mistakes& mistakes);

/// The rotation as a rational one; adds a note if it differs from the file's.
Turn turn_of(const std::array<double, 4>& quaternion, const std::string& whose, Scene& scene);

/// Tells of a joint's limits: left out where they are not reached. The ways of writing that know no stop refuse others.
void note_limits(const Joint& joint, bool are_far, Scene& scene);

}  // namespace slipproof::imported
