// The labelled figure of the model: axes, signs, and what each symbol of a scene means.
#pragma once

#include <string>

#include "mechanics/scene/scene.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// The bicycle of a scene, to scale, with the symbols of lengths, forces and accelerations where they belong: arrows
/// point where a quantity counts as positive. Needs picture_style() in the document.
Element add_bicycle_figure(const Element& parent, const MechanismScene& scene);

/// The same as a file of its own, SVG, on a ground of its own in light and dark.
std::string bicycle_figure_file(const MechanismScene& scene);

}  // namespace slipproof
