// The outlines of bodies in the plane a little later, if the accelerations of a motion stayed as they are: for a
// picture that moves. It is no simulation: contacts and forces are those of the first instant.
#pragma once

#include <vector>

#include "report/picture/mechanism_geometry.hpp"
#include "report/picture/velocities/body_movements.hpp"

namespace slipproof {

inline constexpr double seconds_ahead = 0.5;
inline constexpr int frames_ahead = 10;

/// The outlines that move with bodies, at frames_ahead + 1 times, evenly spaced from 0 to seconds_ahead; circles have a
/// spoke, by which one sees them turn.
std::vector<std::vector<MechanismGeometry::Outline>> outlines_ahead(
    const std::vector<MechanismGeometry::Outline>& outlines, const std::vector<BodyMovement>& movements);

}  // namespace slipproof
