// A scene as one draws it: bodies, points, joints, surfaces and forces, from which the equations of a mechanism follow.
//
// Coordinates are expressions in parameters, definitions and the symbols of angles: x to the right, y up, turns
// counterclockwise; in space x to the right, y away, z up. "In the body's axes" means from its centre of mass, along
// axes that turn with it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// Two coordinates, in space three; null where the file leaves them out. Turns in the plane have z alone.
struct PlacedVector {
  PlacedExpression x, y, z;
  Place place;

  explicit operator bool() const { return x || y || z; }
};

/// About the centre of mass, in the body's axes. In the plane zz alone.
struct PlacedInertia {
  std::array<PlacedExpression, 6> entries;  ///< xx yy zz xy xz yz

  explicit operator bool() const { return static_cast<bool>(entries[2]); }
  Place place() const { return (entries[0] ? entries[0] : entries[2]).place(); }
  /// Null: 0.
  const PlacedExpression& at(std::size_t i, std::size_t j) const { return entries[i == j ? i : i + j + 2]; }
};

/// An outline of a body, in the axes of the body.
struct BodyShape {
  enum class Kind : std::uint8_t { polygon, line, box, circle, sphere, cylinder, capsule, hull };
  Kind kind = Kind::polygon;
  std::vector<PlacedVector> points;  ///< vertices of a polygon, line or hull; the centre of others, if given
  PlacedVector axis;                 ///< of a cylinder or capsule; along z if left out
  PlacedExpression width, depth, height, radius;  ///< of a box; of what is round, with the height of its straight part
  Place place;
};

/// How a joint places a body, in place of `at`: it is turned against the joint's other body as its angle, quaternion,
/// or axis and angle say, the second body against the first.
struct BodyPlacement {
  PlacedText joint;               ///< its name
  PlacedExpression displacement;  ///< of the second body along the axis of a slider; 0 if left out
};

struct Body {
  /// The name of an unknown acceleration, and whether it counts in the opposite direction.
  struct Unknown {
    std::string symbol;
    bool negated = false;
    Place place;
  };
  std::string name;
  PlacedExpression mass;                       ///< null: its motion is prescribed
  PlacedInertia inertia;                       ///< none: its turning is prescribed
  PlacedVector at;                             ///< the centre of mass; the origin if left out
  PlacedExpression cosine, sine;               ///< of the angle of its axes; null: along those of the scene
  PlacedVector turn_axis;                      ///< in space: the axis of that angle
  std::array<PlacedExpression, 4> quaternion;  ///< in space, instead: w x y z, of any length but 0
  std::optional<BodyPlacement> by;             ///< the joint that places it
  std::vector<Expression> rotation;            ///< where one does: the nine entries that follow, row by row
  PlacedVector velocity;                       ///< of the centre of mass; 0 if left out and not in [state]
  PlacedVector spin;                           ///< in the axes of the scene
  PlacedVector acceleration;                   ///< prescribed, of `at`
  PlacedVector turning;                        ///< prescribed angular acceleration
  /// Accelerations along x, y, z, then turnings about them; without a symbol: prescribed, or not in the plane.
  std::array<Unknown, 6> unknowns;
  std::vector<BodyShape> shapes;
  Place place;

  bool is_prescribed() const { return !mass; }
  bool turns_freely() const { return static_cast<bool>(inertia); }
};

/// The body that is always there, at rest, with the axes of the scene: the first of all.
inline constexpr std::size_t ground = 0;

/// A point, or a disc around it, on a line or a disc of another body. In space discs are spheres, and lines planes.
struct BodyContact {
  std::size_t contact = 0;  ///< among the mechanism's, which has its name, friction and forces
  std::size_t of = 0, on = ground;
  PlacedVector point;          ///< in the axes of `of`
  PlacedExpression radius;     ///< radius of the disc; null: a point
  PlacedVector normal;         ///< of the line, in the axes of `on`, out of it
  PlacedVector through;        ///< a point of the line, in the axes of `on`
  PlacedVector on_point;       ///< or the centre of the disc on `on`,
  PlacedExpression on_radius;  ///< negative for the inside of a ring
  PlacedVector
      slip_direction;    ///< where the slip counts positive: along the line; the normal turned clockwise if left out
  PlacedVector tangent;  ///< in space: the direction of the first slip, in the axes of `on`
  PlacedExpression rolling_resistance;      ///< a length
  PlacedExpression restitution;             ///< of impacts, 0 to 1; null: not given
  PlacedExpression tangential_restitution;  ///< null: 0
  std::optional<std::size_t> rolling;       ///< its friction element
  std::string rolling_force;                ///< the name in the file; empty: the default
  bool state_given = false, well_named = false;
  Place place;
};

struct BodyJoint {
  enum class Kind : std::uint8_t { pin, slider, weld, rod, rope, spring, gear, ball, hinge, cylindrical, universal };
  Kind kind = Kind::pin;
  std::string name;
  std::size_t first = 0, second = 0;
  PlacedVector at, to;        ///< in the axes of the first, of the second; `to`: the same place if left out
  PlacedVector axis;          ///< of a slider, hinge, ...: in the axes of the first
  PlacedVector to_axis;       ///< second axis of a universal joint or gear, in the axes of the second
  PlacedExpression length;    ///< length of a rod, rope or spring
  PlacedExpression tension;   ///< present tension of a spring
  PlacedExpression armature;  ///< inertia against the joint's rate alone, a mass against its speed; null: 0
  PlacedExpression ratio;     ///< gear: angular velocity of the second over that of the first, relative to the carrier
  std::size_t carrier = ground;
  std::vector<std::size_t> links;      ///< among the mechanism's
  std::optional<std::size_t> contact;  ///< contact of a rope or a freewheel
  /// With friction: a contact of the scene in its place, half its length ahead of `to` or behind, and in space half its
  /// width across.
  struct Guide {
    std::size_t contact = 0;
    int ahead = 0, across = 0;
  };
  std::vector<Guide> guides;
  PlacedExpression radius, ring;  ///< of a pin or hinge with friction, and of the ring around it
  PlacedVector normal;            ///< in space, of a slider with friction: of its rail, in the axes of the first
  PlacedExpression width;         ///< and of its carriage
  std::map<std::string, std::string, std::less<>> force_names;  ///< names in the file, by what they are along
  bool state_given = false, well_named = false;
  Place place;
};

/// The kinds of joints as files write them, in their order. A pin is in the plane, and what comes after the gear in
/// space.
inline constexpr std::array<std::string_view, 11> joint_kinds{
    "pin", "slider", "weld", "rod", "rope", "spring", "gear", "ball", "hinge", "cylindrical", "universal"};
/// Those of the plane (2), or of space (3).
constexpr std::span<const std::string_view> joint_kinds_of(std::size_t dimension) {
  const std::span<const std::string_view> all = joint_kinds;
  return dimension == 2 ? all.first(7) : all.subspan(1);
}
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
  PlacedVector at;  ///< in the axes of `on`; the centre of mass if left out
  PlacedVector is;  ///< in the axes of the scene, or of the body
  bool follows = false;
  std::optional<std::size_t> back_on;
  Place place;
};

struct BodyTorque {
  std::size_t on = 0;
  PlacedVector is;  ///< in the axes of the scene, or of the body
  bool follows = false;
  std::optional<std::size_t> back_on;
  Place place;
};

/// An entry of [state]: one number that is known of the velocities.
struct BodyRate {
  enum class Kind : std::uint8_t {
    spin,      ///< of a body
    velocity,  ///< of a point of a body
    rate,      ///< of a joint: the spin of the second body against the first, about its axis
    speed,     ///< of a joint: of the second body along its axis
    opening,   ///< of a contact
    sliding
  };
  Kind kind = Kind::spin;
  std::string name;      ///< as the file has it: `crank.spin`
  std::size_t of = 0;    ///< a body; a joint, those that are guides after the others; a contact of the scene
  std::size_t axis = 2;  ///< of a spin or velocity: the component
  PlacedVector at;       ///< of a velocity: the point, in the axes of the body
  PlacedExpression is;
};

struct Bodies {
  std::size_t dimension = 2;  ///< 2: the plane; 3: space
  PlacedVector gravity;       ///< null: the file states that there is none, or has no masses
  std::vector<Body> bodies;   ///< the ground first
  std::vector<BodyContact> contacts;
  std::vector<BodyJoint> joints;
  std::vector<BodyJoint> guides;  ///< joints with friction, in whose place contacts stand
  std::vector<BodyRate> rates;
  std::vector<BodyFriction> friction;
  std::vector<BodyForce> forces;
  std::vector<BodyTorque> torques;
};

/// visit(expression, key, may_have_the_load) for everything that a file says in expressions, friction and limits aside.
template <class Scene, class Visit>
void visit_expressions(Scene& scene, Visit&& visit) {
  const auto all = [&](auto& vector, std::string_view key, bool load) {
    visit(vector.x, key, load);
    visit(vector.y, key, load);
    visit(vector.z, key, load);
  };
  all(scene.gravity, "gravity", false);
  for (auto& body : scene.bodies) {
    visit(body.mass, "mass", false);
    for (auto& entry : body.inertia.entries) visit(entry, "inertia", false);
    all(body.at, "at", false);
    visit(body.cosine, "angle", false);
    visit(body.sine, "angle", false);
    all(body.turn_axis, "axis", false);
    for (auto& entry : body.quaternion) visit(entry, "turn", false);
    if (body.by) visit(body.by->displacement, "displacement", false);
    all(body.velocity, "velocity", false);
    all(body.spin, "spin", false);
    all(body.acceleration, "acceleration", true);
    all(body.turning, "turning", true);
    for (auto& shape : body.shapes) {
      for (auto& point : shape.points) all(point, "shape", false);
      all(shape.axis, "axis", false);
      visit(shape.width, "box", false);
      visit(shape.depth, "box", false);
      visit(shape.height, "box", false);
      visit(shape.radius, "circle", false);
    }
  }
  for (auto& contact : scene.contacts) {
    all(contact.point, "point", false);
    visit(contact.radius, "radius", false);
    all(contact.normal, "normal", false);
    all(contact.through, "through", false);
    all(contact.on_point, "on_point", false);
    visit(contact.on_radius, "on_radius", false);
    all(contact.slip_direction, "slip_direction", false);
    all(contact.tangent, "tangent", false);
    visit(contact.rolling_resistance, "rolling_resistance", false);
    visit(contact.restitution, "restitution", false);
    visit(contact.tangential_restitution, "tangential_restitution", false);
  }
  for (auto* joints : {&scene.joints, &scene.guides}) {
    for (auto& joint : *joints) {
      all(joint.at, "at", false);
      all(joint.to, "to", false);
      all(joint.axis, "axis", false);
      all(joint.to_axis, "to_axis", false);
      visit(joint.length, "length", false);
      visit(joint.tension, "force", true);
      visit(joint.ratio, "ratio", false);
      visit(joint.armature, "armature", false);
      visit(joint.radius, "radius", false);
      visit(joint.ring, "ring", false);
      all(joint.normal, "normal", false);
      visit(joint.width, "width", false);
    }
  }
  for (auto& rate : scene.rates) {
    all(rate.at, "at", false);
    visit(rate.is, rate.name, false);
  }
  for (auto& force : scene.forces) {
    all(force.at, "at", false);
    all(force.is, "is", true);
  }
  for (auto& torque : scene.torques) all(torque.is, "is", true);
}

}  // namespace slipproof
