// All motions of a scene side by side in one picture.
#pragma once

#include <string>
#include <vector>

#include "mechanics/kernel/motion.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/picture/mechanism_svg.hpp"

namespace slipproof {

/// The motions at the load, and each continuum as a motion whose forces have ranges: what `draw --motion` counts.
std::vector<MotionAtLoad> drawn_motions(const MotionsAtLoad& found);

/// What the pictures of these motions share: the scale of forces, the form of numbers, nothing listed below.
CommonLook common_look(const MechanismScene& scene, const std::vector<MotionAtLoad>& motions);

/// An SVG file with a picture for each motion, at most three in a row, under the numbers that `solve` gives them. All
/// have one scale, and all numbers one form. Without a motion it shows the mechanism, and says that there is none.
/// Throws InputError as add_mechanism() does.
std::string motions_svg_file(const MechanismScene& scene, const MotionsAtLoad& found);

}  // namespace slipproof
