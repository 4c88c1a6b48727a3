// A scene of rigid bodies in space, as URDF, SDF and MJCF know it: at rest, in one configuration, in one frame.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "contact/imported/space.hpp"

namespace slipproof::imported {

/// What a body is made of where it touches. In its own axes a cylinder and a capsule lie along z.
struct Shape {
  enum class Kind : std::uint8_t { box, sphere, cylinder, capsule, plane };
  Kind kind = Kind::box;
  std::string name;
  Vector half;               ///< of a box: half of its edges
  Rational radius = 0;       ///< of the round ones
  Rational half_length = 0;  ///< of a cylinder, and of a capsule without its ends
  Pose pose;                 ///< in the scene
  /// Of friction; in SDF along two directions, where the greater counts only if it is the pair's as well.
  std::optional<Rational> mu, greater_mu;
  /// Two shapes touch where the first's kinds have a bit of what the second meets, or the other way round.
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

/// What holds two bodies to each other, and where.
struct Joint {
  enum class Kind : std::uint8_t { fixed, hinge, slide };
  Kind kind = Kind::fixed;
  std::string name;
  std::size_t first = 0, second = 0;  ///< bodies
  Vector at, axis;                    ///< in the scene; the axis of any length
  Rational friction = 0;              ///< a couple that holds a hinge
  Place place;
};

/// How the format's engine makes one coefficient of friction of two.
enum class FrictionRule : std::uint8_t { none, least, greatest };

struct Scene {
  std::string file, format, name;
  std::optional<Vector> gravity;            ///< nothing: the format has none
  std::vector<Body> bodies = the_ground();  ///< the first is what does not move
  std::vector<Joint> joints;
  FrictionRule rule = FrictionRule::none;
  std::vector<std::string> import_notes;  ///< sentences about what was left out, moved or turned
};

/// Makes one body of those that are held fixed to each other, and of those fixed to the ground the ground. Bodies that
/// are left without a mass become mistakes.
void join_fixed(Scene& scene, Mistakes& mistakes);

/// The coefficient where two shapes touch: `given`, or by the format's rule. Nothing where neither says one, or the two
/// directions have different ones.
std::optional<Rational> friction_between(const Scene& scene, const Shape& a, const Shape& b,
                                         const std::optional<Rational>& given);

/// Whether a joint holds two bodies that move to each other: then their shapes do not touch, as in the formats'
/// engines, in which what is held to the ground may touch it.
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
