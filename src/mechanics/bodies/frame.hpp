// Where a body is and how it moves: the positions, velocities and accelerations of its points.
#pragma once

#include <vector>

#include "mechanics/bodies/bodies.hpp"
#include "mechanics/bodies/planar.hpp"

namespace slipproof::bodies_in_motion {

/// An expression without its columns, which count in another text than where a derived expression stands; 0 for null.
Expression unplaced(const PlacedExpression& placed);
/// The vector of a pair without places; 0 if it is left out.
PlanarVector unplaced(const PlacedPair& pair);

/// A body at the instant of the scene. Accelerations that are not prescribed are symbols of unknowns.
struct Frame {
  PlanarVector at;
  Expression cosine, sine;
  PlanarVector velocity;
  Expression spin;
  PlanarVector acceleration;
  Expression turning;

  explicit Frame(const Body& body);

  /// A vector from the body's axes into those of the scene, and back.
  PlanarVector in_scene(const PlanarVector& own) const;
  PlanarVector in_body(const PlanarVector& scene) const;

  // Of the body's material point at a place of the scene that is `arm` from the body's centre of mass.
  PlanarVector velocity_at(const PlanarVector& arm) const;
  PlanarVector acceleration_at(const PlanarVector& arm) const;
};

std::vector<Frame> frames(const Bodies& bodies);

/// A point of one body as it moves.
struct MovingPoint {
  PlanarVector place, velocity, acceleration;
  MovingPoint(const Frame& frame, const PlanarVector& own);
};

/// A point as an observer on a body sees it.
struct RelativePoint {
  PlanarVector velocity, acceleration;
  RelativePoint(const MovingPoint& point, const Frame& observer);
};

}  // namespace slipproof::bodies_in_motion
