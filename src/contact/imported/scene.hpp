// A scene of rigid bodies in space, as URDF, SDF and MJCF know it: at rest, in one configuration, in one frame.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "contact/imported/space.hpp"

namespace slipproof::imported {

/// A collision shape of a body. Cylinders and capsules lie along the z axis of the shape.
struct Shape {
  enum class Kind : std::uint8_t { box, sphere, cylinder, capsule, plane };
  Kind kind = Kind::box;
  std::string name;
  Vector half;               ///< half edges of a box
  Rational radius = 0;       ///< radius of a round shape
  Rational half_length = 0;  ///< half length of a cylinder, and of a capsule without its caps
  Pose pose;                 ///< in the scene
  /// Coefficients of friction; SDF has one for each of two directions, and the greater counts only if it is also that
  /// of the pair.
  std::optional<Rational> mu, greater_mu;
  /// Bit masks: two shapes can touch if `kinds` of one has a bit of `meets` of the other.
  unsigned kinds = 1, meets = 1;
  Place place;
};
std::string_view name(Shape::Kind kind);

struct Body {
  std::string name;
  Rational mass = 0;
  Vector at;        ///< its centre of mass, in the scene
  Inertia inertia;  ///< about it, along the scene's axes
  std::vector<Shape> shapes;
  Place place;
};
inline std::vector<Body> the_ground() {
  std::vector<Body> bodies(1);
  bodies[0].name = "ground";
  return bodies;
}

/// A joint between two bodies, and its place.
struct Joint {
  enum class Kind : std::uint8_t { fixed, hinge, slide };
  Kind kind = Kind::fixed;
  std::string name;
  std::size_t first = 0, second = 0;  ///< bodies
  Vector at, axis;                    ///< in the scene; the axis of any length
  Rational friction = 0;              ///< a couple that holds a hinge
  Place place;
};

/// The rule by which the format's engine combines two coefficients of friction.
enum class FrictionRule : std::uint8_t { none, least, greatest };

struct Scene {
  std::string file, format, name;
  std::optional<Vector> gravity;            ///< nothing: the format has none
  std::vector<Body> bodies = the_ground();  ///< the first is what does not move
  std::vector<Joint> joints;
  FrictionRule rule = FrictionRule::none;
  std::vector<std::string> import_notes;  ///< sentences about what was left out, moved or turned
};

/// Merges bodies that are fixed to each other, and bodies fixed to the ground with the ground. Reports bodies that
/// remain without a mass.
void join_fixed(Scene& scene, Mistakes& mistakes);

/// The coefficient where two shapes touch: `given`, or by the format's rule. Nothing where neither says one, or the two
/// directions have different ones.
std::optional<Rational> friction_between(const Scene& scene, const Shape& a, const Shape& b,
                                         const std::optional<Rational>& given);

/// True if a joint connects two moving bodies. Their shapes then do not touch, as in the engines of the formats; a body
/// joined to the ground may touch it.
bool are_joined(const Scene& scene, std::size_t a, std::size_t b);
bool may_touch(const Shape& a, const Shape& b);

/// `name` with what no identifier has made `_`, and a number behind it if it was used before.
class Identifiers {
 public:
  std::string operator()(const std::string& name);

 private:
  std::vector<std::string> used_;
};

}  // namespace slipproof::imported
