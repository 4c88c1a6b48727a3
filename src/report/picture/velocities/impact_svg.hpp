// An impact drawn: before, and after with each outcome.
#pragma once

#include <string>

#include "contact/impact/solved_impact.hpp"
#include "report/picture/space/vectors.hpp"

namespace slipproof {

/// An SVG file. In the plane the scene before and each outcome are side by side, to one scale: velocities in green, the
/// impulses of contacts as the forces of a motion are. In space each outcome is a picture, seen from a direction, with
/// velocities before as whole lines, and dotted those after. Throws InputError if there is no picture.
std::string impact_svg_file(const SolvedImpact& solved, const Vec3& from);

}  // namespace slipproof
