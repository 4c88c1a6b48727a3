// How the bodies of a scene begin to move in one of its motions, for pictures that move.
#pragma once

#include <vector>

#include "mechanics/kernel/motion.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/picture/drawing.hpp"

namespace slipproof {

/// Rounded to binary64, in the units of the file, counterclockwise.
struct BodyMovement {
  Point at;  ///< the centre of mass
  Point velocity, acceleration;
  double spin = 0, turning = 0;

  /// Where a point of the body is after `time`, if these accelerations stayed as they are.
  Point after(double time, Point point) const;
};

/// One for each body, the ground first, in axes from which those of the file are `turned`; none of a mechanism by
/// equations, which does not say how its shapes move. `motion` must be one of the scene's.
std::vector<BodyMovement> body_movements(const MechanismScene& scene, const MotionAtLoad& motion, double turned);

}  // namespace slipproof
