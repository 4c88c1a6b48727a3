// A scene in space as a contact problem at rest.
#pragma once

#include <string>
#include <vector>

#include "contact/problem/global_problem.hpp"
#include "contact/exchange/touch.hpp"

namespace slipproof::imported {

struct SpatialProblem {
  GlobalProblem problem;  ///< v: three accelerations of each body's centre of mass, then three of its turning
  std::vector<std::string> import_notes;  ///< remarks: parts that were left out, moved, turned or assumed
};

/// Contacts are points: the corners of a box on a plane, the corners of the common polygon of two faces, the lowest
/// points of round shapes, and four points of the rim of a standing cylinder, which is noted. Each is moved to where
/// the surfaces meet. Throws InputError for overlapping shapes, and for kinds of touching that are not supported.
SpatialProblem to_spatial(Scene scene, const TouchOptions& options);

}  // namespace slipproof::imported
