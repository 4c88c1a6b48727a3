// Whether the accelerations of a motion leave no choice of its forces.
#pragma once

#include "claims/plain/plain_signs.hpp"
#include "mechanics/family/family.hpp"

namespace slipproof {

/// True if the forces of every motion of the scene plainly follow from its accelerations and the load: the columns of
/// all forces in the equations of motion are independent at every point, by Gaussian elimination with pivots that have
/// a plain sign. False where this is not plain; forces may then be open at some point.
bool plainly_determine_forces(const Family& scene, const PlainSigns& signs);

}  // namespace slipproof
