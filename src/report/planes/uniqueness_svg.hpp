// Under which loads a scene has one motion, several, infinitely many or none, over a parameter.
#pragma once

#include <string>

#include "claims/uniqueness/along.hpp"
#include "report/phase/phase_diagram.hpp"

namespace slipproof {

/// The plane of the parameter and the load around what is found: exact in so many columns, joined up between them. The
/// line's values are its own. Throws std::invalid_argument, with a message for people, for a scene without a load.
PhaseDiagram uniqueness_diagram(const MechanismScene& scene, const UniquenessAlong& along, std::size_t columns = 240);

/// A file of its own, with legend and style.
std::string uniqueness_svg(const PhaseDiagram& diagram, const UniquenessAlong& along);

}  // namespace slipproof
