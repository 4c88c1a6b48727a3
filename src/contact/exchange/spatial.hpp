// A scene in space as a contact problem at rest.
#pragma once

#include <string>
#include <vector>

#include "contact/exchange/global_problem.hpp"
#include "contact/exchange/touch.hpp"

namespace slipproof::imported {

struct SpatialProblem {
  GlobalProblem problem;  ///< v: three accelerations of each body's centre of mass, then three of its turning
  std::vector<std::string> import_notes;  ///< what was left out, moved, turned or assumed
};

/// Contacts are points: the corners of a box on a plane, those of the polygon in which two faces meet, the lowest
/// points of round shapes; four points of the rim of a cylinder that stands, which is told. Each is moved to where the
/// surfaces meet. Throws InputError where shapes are inside each other, or touch in a way that is not read.
SpatialProblem to_spatial(Scene scene, const TouchOptions& options);

}  // namespace slipproof::imported
