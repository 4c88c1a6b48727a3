// A scene of bodies drawn at one point of the domain, exactly: where bodies, their outlines and contacts are. The plane
// is the one in space with z = 0.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mechanics/bodies/frame.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof::mechanism_checks::drawn {

struct Spot {
  Rational x = 0, y = 0, z = 0;
  bool operator==(const Spot&) const = default;
  const Rational& operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};
inline Spot operator-(const Spot& a, const Spot& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Spot operator+(const Spot& a, const Spot& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Spot operator*(const Rational& factor, const Spot& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
inline Rational dot(const Spot& a, const Spot& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Spot cross(const Spot& a, const Spot& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The box along three axes around places.
struct Box {
  Spot low, high;

  explicit Box(const Spot& place) : low(place), high(place) {}
  void take(const Spot& place, const Rational& reach);
  bool holds(const Spot& place) const;
};

/// What a shape reaches: all places at most `radius` from the hull of its corners. Of a cylinder the corners are the
/// middles of its ends, and `blunt` says that it reaches less than that.
struct Outline {
  std::vector<Spot> own, corners;  ///< in the axes of the body, of the scene
  Rational radius = 0;
  bool blunt = false;
};

class Drawing {
 public:
  /// All must outlive it.
  Drawing(const Bodies& scene, const std::vector<bodies_in_motion::Frame>& frames, const ProblemMaker& maker,
          const MechanismValues& values);

  /// Whether all that was asked for has a value there; what divides by 0 has none.
  bool has_values() const { return has_values_; }

  Rational number(const Expression& expression);
  Rational number(const PlacedExpression& placed) { return placed ? number(placed.expression) : Rational(0); }
  Spot spot(const bodies_in_motion::SceneVector& v) { return {number(v.x), number(v.y), number(v.z)}; }
  /// As the file has it, in the axes of the body.
  Spot own(const PlacedVector& vector) { return spot(bodies_in_motion::unplaced(vector)); }
  Spot centre(std::size_t body) { return spot(frames_[body].at); }
  Spot direction(std::size_t body, const PlacedVector& own);
  Spot place(std::size_t body, const PlacedVector& own) { return centre(body) + direction(body, own); }
  /// Where a contact with a line or a plane touches.
  Spot touches(const BodyContact& contact);

  const std::vector<Outline>& outlines(std::size_t body) const { return outlines_[body]; }
  /// Whether all is inside one convex outline: only then a plane along its side leaves it on one side.
  bool is_convex(std::size_t body) const;
  /// The box along the axes of the scene around what is known of a body.
  Box box(std::size_t body);
  /// The box along its own axes around its shapes; nothing without shapes.
  std::optional<Box> own_box(std::size_t body) const;

 private:
  Outline outline(std::size_t body, const BodyShape& shape);
  std::vector<Spot> corners_of(const BodyShape& shape);

  const Bodies& scene_;
  const std::vector<bodies_in_motion::Frame>& frames_;
  const CompiledMechanism& compiled_;
  Evaluator<Rational> at_;
  bool has_values_ = true;
  std::vector<std::array<Spot, 3>> axes_;  ///< of each body, in the scene
  std::vector<std::vector<Outline>> outlines_;
};

/// Whether an outline reaches beyond a place along a direction.
bool reaches_beyond(const Outline& outline, const Spot& place, const Spot& direction);
/// Whether two convex outlines have more in common than a border. Round ones are compared where both have one corner,
/// others where both have extent in the plane or in space. Up to 12 corners.
bool overlap(const Outline& a, const Outline& b, std::size_t dimension);
/// Whether the faces of a hull that lie in a plane with this normal through a place, if there are any, end before it.
bool face_ends_before(const Outline& outline, const Spot& place, const Spot& normal);

}  // namespace slipproof::mechanism_checks::drawn
