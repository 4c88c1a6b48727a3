// A bicycle seen from the side, with the forces of a motion as arrows.
#pragma once

#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// Adds the scene, drawn to scale, with the forces of `motion` in proportion to each other and with their exact values:
/// normal reactions from below, tangential ones along the road, the weight, the pedal force and the acceleration. A
/// wheel that leaves the road is drawn raised, not to scale but visibly, with a dotted trace where it was. A force that
/// is undetermined is drawn at the middle of its range. Without a motion, only the bicycle is drawn. Needs
/// picture_style() in the document.
Element add_bicycle(const Element& parent, const MechanismScene& scene, const MotionAtLoad* motion,
                    std::string_view title);

}  // namespace slipproof
