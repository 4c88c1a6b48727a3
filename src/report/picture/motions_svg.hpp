// All motions of a scene side by side in one picture.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mechanics/kernel/motion.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/picture/mechanism_svg.hpp"

namespace slipproof {

/// The motions at the load, and each continuum as a motion whose forces have ranges: what `draw --motion` counts.
std::vector<MotionAtLoad> drawn_motions(const MotionsAtLoad& found);

/// What the pictures of these motions share: the scale of forces, the form of numbers, nothing listed below.
CommonLook common_look(const MechanismScene& scene, const std::vector<MotionAtLoad>& motions);

/// Adds the picture of one motion, or of none: a bicycle with its pedal, or a mechanism.
Element add_motion(const Element& parent, const MechanismScene& scene, const MotionAtLoad* motion,
                   std::string_view title, const CommonLook& look);

/// An SVG file of one motion: a bicycle with its pedal, a wheel that lifts raised; or a mechanism. Throws InputError as
/// add_mechanism() does.
std::string motion_svg_file(const MechanismScene& scene, const MotionAtLoad& motion);

/// An SVG file with a picture for each motion, at most three in a row, under the numbers that `solve` gives them. All
/// have one scale, and all numbers one form. Without a motion it shows the mechanism, and says that there is none. A
/// bicycle is drawn with its pedal, and a wheel that lifts is drawn raised. Throws InputError as add_mechanism() does.
std::string motions_svg_file(const MechanismScene& scene, const MotionsAtLoad& found);

}  // namespace slipproof
