// Reads a scene of a mechanism that has been read before: for those who ask for the same scene at many values.
#pragma once

#include <string>
#include <string_view>

#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// As parse_scene() for the text of a scene whose keys `mechanism` and `along` mean `mechanism`; they are not followed.
/// Reading the mechanism itself takes most of the time of parse_scene(). Throws InputError.
MechanismScene parse_scene_of(const Mechanism& mechanism, std::string_view text, const std::string& file);

}  // namespace slipproof
