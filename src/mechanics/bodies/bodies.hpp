// A scene as one draws it: bodies, points, joints, surfaces and forces, from which the equations of a mechanism follow.
//
// Coordinates are expressions in parameters, definitions and the symbols of angles: x to the right, y up, turns
// counterclockwise. "In the body's axes" means from its centre of mass, along axes that turn with it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// Two coordinates; null where the file leaves them out.
struct PlacedPair {
  PlacedExpression x, y;
  Place place;

  explicit operator bool() const { return x && y; }
};

/// An outline of a body, in the axes of the body.
struct BodyShape {
  enum class Kind : std::uint8_t { polygon, line, box, circle };
  Kind kind = Kind::polygon;
  std::vector<PlacedPair> points;  ///< vertices of a polygon or a line; the centre of a box or a circle, if given
  PlacedExpression width, height, radius;  ///< width and height of a box; radius of a circle
  Place place;
};

struct Body {
  /// The name of an unknown acceleration, and whether it counts in the opposite direction.
  struct Unknown {
    std::string symbol;
    bool negated = false;
    Place place;
  };
  std::string name;
  PlacedExpression mass, inertia;  ///< null: its motion, or its turning, is prescribed
  PlacedPair at;                   ///< the centre of mass; the origin if left out
  PlacedExpression cosine, sine;   ///< cosine and sine of the angle of its axes; null: along x and y
  PlacedPair velocity;             ///< velocity of the centre of mass; 0 if left out
  PlacedExpression spin;
  PlacedPair acceleration;   ///< prescribed, of `at`
  PlacedExpression turning;  ///< prescribed angular acceleration
  Unknown ax, ay, alpha;     ///< without a symbol if prescribed
  std::vector<BodyShape> shapes;
  Place place;

  bool is_prescribed() const { return !mass; }
};

/// The body that is always there, at rest, with the axes of the scene: the first of all.
inline constexpr std::size_t ground = 0;

/// A point, or a disc around it, on a line or a disc of another body.
struct BodyContact {
  std::size_t contact = 0;  ///< among the mechanism's, which has its name, friction and forces
  std::size_t of = 0, on = ground;
  PlacedPair point;            ///< in the axes of `of`
  PlacedExpression radius;     ///< radius of the disc; null: a point
  PlacedPair normal;           ///< of the line, in the axes of `on`, out of it
  PlacedPair through;          ///< a point of the line, in the axes of `on`
  PlacedPair on_point;         ///< or the centre of the disc on `on`,
  PlacedExpression on_radius;  ///< negative for the inside of a ring
  PlacedPair
      slip_direction;  ///< where the slip counts positive: along the line; the normal turned clockwise if left out
  PlacedExpression rolling_resistance;  ///< a length
  std::optional<std::size_t> rolling;   ///< its friction element
  std::string rolling_force;            ///< the name in the file; empty: the default
  bool state_given = false, well_named = false;
  Place place;
};

struct BodyJoint {
  enum class Kind : std::uint8_t { pin, slider, weld, rod, rope, spring, gear };
  Kind kind = Kind::pin;
  std::string name;
  std::size_t first = 0, second = 0;
  PlacedPair at, to;         ///< in the axes of the first, of the second; `to`: the same place if left out
  PlacedPair axis;           ///< axis of a slider, in the axes of the first
  PlacedExpression length;   ///< length of a rod, rope or spring
  PlacedExpression tension;  ///< present tension of a spring
  PlacedExpression ratio;    ///< gear: angular velocity of the second over that of the first, relative to the carrier
  std::size_t carrier = ground;
  std::vector<std::size_t> links;      ///< among the mechanism's
  std::optional<std::size_t> contact;  ///< contact of a rope or a freewheel
  /// Names of the forces in the file; empty: the default. Along x, along y, against turning, across the axis, or the
  /// only force.
  std::array<std::string, 5> force_names;
  bool state_given = false, well_named = false;
  Place place;
};

/// The kinds of joints as files write them, in their order.
inline constexpr std::array<std::string_view, 7> joint_kinds{"pin", "slider", "weld", "rod", "rope", "spring", "gear"};
constexpr std::string_view name(BodyJoint::Kind kind) {
  return joint_kinds[static_cast<std::size_t>(kind)];
}

/// A brake or a clutch: friction against the turning of the second body relative to the first.
struct BodyFriction {
  std::size_t friction = 0;  ///< among the mechanism's
  std::size_t first = 0, second = 0;
  bool state_given = false;
  Place place;
};

struct BodyForce {
  std::size_t on = 0;
  PlacedPair at;  ///< in the axes of `on`; the centre of mass if left out
  PlacedPair is;  ///< in the axes of the scene, or of the body
  bool follows = false;
  std::optional<std::size_t> back_on;
  Place place;
};

struct BodyTorque {
  std::size_t on = 0;
  PlacedExpression is;
  std::optional<std::size_t> back_on;
  Place place;
};

struct Bodies {
  PlacedPair gravity;        ///< null: the file states that there is none, or has no masses
  std::vector<Body> bodies;  ///< the ground first
  std::vector<BodyContact> contacts;
  std::vector<BodyJoint> joints;
  std::vector<BodyFriction> friction;
  std::vector<BodyForce> forces;
  std::vector<BodyTorque> torques;
};

/// visit(expression, key, may_have_the_load) for everything that a file says in expressions, friction and limits aside.
template <class Scene, class Visit>
void visit_expressions(Scene& scene, Visit&& visit) {
  const auto both = [&](auto& pair, std::string_view key, bool load) {
    visit(pair.x, key, load);
    visit(pair.y, key, load);
  };
  both(scene.gravity, "gravity", false);
  for (auto& body : scene.bodies) {
    visit(body.mass, "mass", false);
    visit(body.inertia, "inertia", false);
    both(body.at, "at", false);
    visit(body.cosine, "angle", false);
    visit(body.sine, "angle", false);
    both(body.velocity, "velocity", false);
    visit(body.spin, "spin", false);
    both(body.acceleration, "acceleration", true);
    visit(body.turning, "turning", true);
    for (auto& shape : body.shapes) {
      for (auto& point : shape.points) both(point, "shape", false);
      visit(shape.width, "box", false);
      visit(shape.height, "box", false);
      visit(shape.radius, "circle", false);
    }
  }
  for (auto& contact : scene.contacts) {
    both(contact.point, "point", false);
    visit(contact.radius, "radius", false);
    both(contact.normal, "normal", false);
    both(contact.through, "through", false);
    both(contact.on_point, "on_point", false);
    visit(contact.on_radius, "on_radius", false);
    both(contact.slip_direction, "slip_direction", false);
    visit(contact.rolling_resistance, "rolling_resistance", false);
  }
  for (auto& joint : scene.joints) {
    both(joint.at, "at", false);
    both(joint.to, "to", false);
    both(joint.axis, "axis", false);
    visit(joint.length, "length", false);
    visit(joint.tension, "force", true);
    visit(joint.ratio, "ratio", false);
  }
  for (auto& force : scene.forces) {
    both(force.at, "at", false);
    both(force.is, "is", true);
  }
  for (auto& torque : scene.torques) visit(torque.is, "is", true);
}

}  // namespace slipproof
