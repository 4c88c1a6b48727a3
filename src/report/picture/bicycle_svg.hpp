// A bicycle seen from the side, with the forces of a motion as arrows.
#pragma once

#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// The scene drawn to scale, with the forces of `motion` in proportion to each other and their exact values beside
/// them: normal reactions from below, tangential ones along the road, the weight, the pedal force and the acceleration.
/// A wheel that leaves the road is drawn raised, by no measure but that it can be seen, with a dotted trace where it
/// stood. A force that is undetermined is drawn at the middle of its range. Without a motion, the bicycle alone. Needs
/// picture_style() in the document.
Element add_bicycle(const Element& parent, const MechanismScene& scene, const MotionAtLoad* motion,
                    std::string_view title);

}  // namespace slipproof
