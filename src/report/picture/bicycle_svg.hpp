// A bicycle seen from the side, with the forces of a motion as arrows.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/markup/element.hpp"
#include "report/picture/motion_words.hpp"

namespace slipproof {

/// Adds the scene, drawn to scale, with the forces of `motion` in proportion to each other and with their exact values:
/// normal reactions from below, tangential ones along the road, the weight, the pedal force and the acceleration. A
/// wheel that leaves the road is drawn raised, not to scale but visibly, with a dotted trace where it was. A force that
/// is undetermined is drawn at the middle of its range. Without a motion, only the bicycle is drawn. Needs
/// picture_style() in the document.
/// Numbers are written as `numbers` says, otherwise as fits this picture.
Element add_bicycle(const Element& parent, const MechanismScene& scene, const MotionAtLoad* motion,
                    std::string_view title, const std::optional<NumberWords>& numbers = {});

/// The numbers that the picture shows; none without a motion.
std::vector<Range> bicycle_numbers(const MechanismScene& scene, const MotionAtLoad* motion);

}  // namespace slipproof
