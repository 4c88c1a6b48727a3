// A paper's plane: the exact motions, and beside them the paper's thresholds and claims.
#pragma once

#include "report/phase/phase_diagram.hpp"
#include "report/planes/figures.hpp"

namespace slipproof {

/// The plane of a figure. Its curves are the definitions that the claims compare a force with, its lines those that
/// they compare x with, as printed and as repaired; its claims are those about which motions there are, in a reading.
/// What the plane solves refers to `claims`, which must outlive it. Throws InputError where the figure's values make no
/// bicycle.
Plane claims_plane(const ClaimsFile& claims, const Figure& figure, Reading reading);

}  // namespace slipproof
