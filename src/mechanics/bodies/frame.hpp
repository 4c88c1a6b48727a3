// Where a body is and how it moves: the positions, velocities and accelerations of its points.
#pragma once

#include <array>
#include <vector>

#include "mechanics/bodies/bodies.hpp"
#include "mechanics/bodies/vectors.hpp"

namespace slipproof::bodies_in_motion {

/// An expression without its columns, which count in another text than where a derived expression stands; 0 for null.
Expression unplaced(const PlacedExpression& placed);
/// A vector without places; 0 if it is left out.
SceneVector unplaced(const PlacedVector& placed);

/// How the axes of a body are turned: a rotation by its nine entries.
class Turn {
 public:
  /// Of a body's rotation, or of its angle, quaternion, or axis and angle.
  explicit Turn(const Body& body);

  SceneVector in_scene(const SceneVector& own) const;
  SceneVector in_body(const SceneVector& scene) const;
  /// Component `row` of the body's axis `column`, in the axes of the scene.
  Expression entry(std::size_t row, std::size_t column) const;

 private:
  struct Entry {
    Expression value = zero_literal();
    bool negated = false;  ///< it is subtracted, after the others are added: the sine of a turn in the plane
  };
  void by_entries(const std::vector<Expression>& rotation);
  void by_angle(const Expression& cosine, const Expression& sine);
  void by_quaternion(const std::array<Expression, 4>& q);
  void about(const SceneVector& axis, const Expression& cosine, const Expression& sine);

  std::array<std::array<Entry, 3>, 3> entries_;
};

/// A body at the instant of the scene. Accelerations that are not prescribed are symbols of unknowns.
struct Frame {
  SceneVector at;
  Turn turn;
  SceneVector velocity, spin, acceleration, turning;

  explicit Frame(const Body& body);

  /// A vector from the body's axes into those of the scene, and back.
  SceneVector in_scene(const SceneVector& own) const { return turn.in_scene(own); }
  SceneVector in_body(const SceneVector& scene) const { return turn.in_body(scene); }

  // Of the body's material point at a place of the scene that is `arm` from the body's centre of mass.
  SceneVector velocity_at(const SceneVector& arm) const;
  SceneVector acceleration_at(const SceneVector& arm) const;
};

std::vector<Frame> frames(const Bodies& bodies);

/// A point of one body as it moves.
struct MovingPoint {
  SceneVector place, velocity, acceleration;
  MovingPoint(const Frame& frame, const SceneVector& own);
};

/// A point as an observer on a body sees it.
struct RelativePoint {
  SceneVector velocity, acceleration;
  RelativePoint(const MovingPoint& point, const Frame& observer);
};

}  // namespace slipproof::bodies_in_motion
