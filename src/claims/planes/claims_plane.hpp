// The plane of a paper: the exact motions, with the paper's thresholds and claims.
#pragma once

#include "claims/planes/figures.hpp"
#include "mechanics/planes/phase_diagram.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// The plane of a figure. Its curves are the definitions that the claims compare a force with. Its lines are the
/// definitions that they compare x with, as printed and as repaired. Its claims are those that state which motions
/// there are, in one reading. The functions in the plane refer to `claims`, which must outlive it. Throws InputError if
/// the figure's values are not a bicycle.
Plane claims_plane(const ClaimsFile& claims, const Figure& figure, Reading reading);

/// The scene in the middle of a figure whose plane there is.
MechanismScene figure_scene(const ClaimsFile& claims, const Figure& figure);

}  // namespace slipproof
