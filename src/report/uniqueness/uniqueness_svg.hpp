// Shows over a parameter for which loads a scene has one motion, several, infinitely many or none.
#pragma once

#include <string>

#include "claims/uniqueness/along.hpp"
#include "mechanics/planes/phase_diagram.hpp"

namespace slipproof {

/// The plane of the parameter and the load around the ranges found: exact in so many columns, joined between them. The
/// values of the line have columns of their own. Throws std::invalid_argument, with a message for people, if the scene
/// has no load.
PhaseDiagram uniqueness_diagram(const MechanismScene& scene, const UniquenessAlong& along, std::size_t columns = 240);

/// An SVG file with legend and style.
std::string uniqueness_svg(const PhaseDiagram& diagram, const UniquenessAlong& along);

}  // namespace slipproof
