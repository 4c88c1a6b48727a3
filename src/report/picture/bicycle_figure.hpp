// The labelled figure of the model: axes, signs, and the meaning of each symbol of a scene.
#pragma once

#include <string>

#include "mechanics/scene/scene.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// Adds the bicycle of a scene, to scale, with the symbols of lengths, forces and accelerations at their places. Arrows
/// point in the positive directions. Needs picture_style() in the document.
Element add_bicycle_figure(const Element& parent, const MechanismScene& scene);

/// The same as an SVG file of its own, with a background for light and dark displays.
std::string bicycle_figure_file(const MechanismScene& scene);

}  // namespace slipproof
