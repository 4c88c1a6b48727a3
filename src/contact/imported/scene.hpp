// A scene of rigid bodies in space, as URDF, SDF and MJCF know it: in one configuration, in one frame, at one instant.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "contact/imported/space.hpp"

namespace slipproof::imported {

/// A collision shape of a body. Cylinders and capsules lie along the z axis of the shape; a hull is that of points.
struct Shape {
  enum class Kind : std::uint8_t { box, sphere, cylinder, capsule, plane, hull };
  Kind kind = Kind::box;
  std::string name;
  Vector half;                                        ///< half edges of a box
  Rational radius = 0;                                ///< radius of a round shape
  Rational half_length = 0;                           ///< half length of a cylinder, and of a capsule without its caps
  std::vector<Vector> points;                         ///< of a hull, in the axes of the shape
  std::vector<std::array<std::size_t, 3>> triangles;  ///< of its surface, by its points
  Pose pose;                                          ///< in the scene
  /// Coefficients of friction; SDF has one for each of two directions, and the greater counts only if it is also that
  /// of the pair.
  std::optional<Rational> mu, greater_mu;
  /// Bit masks: two shapes can touch if `kinds` of one has a bit of `meets` of the other.
  unsigned kinds = 1, meets = 1;
  int priority = 0;  ///< of two shapes the one with the greater one says the friction (MJCF)
  Place place;
};
std::string_view name(Shape::Kind kind);

struct Body {
  std::string name;
  Rational mass = 0;
  Vector at;        ///< its centre of mass, in the scene
  Inertia inertia;  ///< about it, along the scene's axes
  Vector velocity;  ///< of the centre of mass
  Vector spin;      ///< along the scene's axes
  std::vector<Shape> shapes;
  bool turns = true;      ///< false: slides hold it as it stands
  bool massless = false;  ///< a link that stands between several joints of one body
  Place place;
};
inline std::vector<Body> the_ground() {
  std::vector<Body> bodies(1);
  bodies[0].name = "ground";
  return bodies;
}

/// A joint between two bodies, and its place.
struct Joint {
  enum class Kind : std::uint8_t { fixed, hinge, slide, ball };
  Kind kind = Kind::fixed;
  std::string name;
  std::size_t first = 0, second = 0;  ///< bodies
  Vector at, axis;                    ///< in the scene; the axis of any length
  Rational friction = 0;              ///< a couple that holds a hinge, a force that holds a slide
  Place place;
  Rational armature = 0;  ///< inertia against the rate of the joint alone, of a motor's rotor behind its gears
};

/// A force and a couple on a body, in the scene, with their reaction on another (the ground: nothing).
struct Push {
  std::string name;
  std::size_t on = 0, back_on = 0;
  Vector force, at, couple;
};

/// What not every way of writing a scene can say. The mechanism in space says it, or leaves it out with a sentence; the
/// others refuse it.
struct OnlyInSpace {
  Place place;
  std::string found;     ///< the mistake of those that cannot say it
  std::string left_out;  ///< the sentence; empty: it is said in full
};

/// The rule by which the format's engine combines two coefficients of friction.
enum class FrictionRule : std::uint8_t { none, least, greatest };

struct Scene {
  std::string file, format, name;
  std::optional<Vector> gravity;            ///< nothing: the format has none
  std::vector<Body> bodies = the_ground();  ///< the first is what does not move
  std::vector<Joint> joints;
  std::vector<Push> pushes;
  std::vector<std::pair<std::size_t, std::size_t>> excluded;  ///< bodies that do not touch each other
  std::vector<OnlyInSpace> only_in_space;
  FrictionRule rule = FrictionRule::none;
  std::vector<std::string> import_notes;  ///< sentences about what was left out, moved or turned
};

/// How a scene is read where its format leaves a choice.
struct ReadOptions {
  std::string key;               ///< MJCF: the keyframe; empty: the default configuration, at rest
  bool without_meshes = false;   ///< leaves out the shapes of meshes
  std::optional<Rational> mass;  ///< of bodies that have none, which then have as many kg m^2 about all axes
};

/// Merges bodies that are fixed to each other, and bodies fixed to the ground with the ground. Reports bodies that
/// remain without a mass.
void join_fixed(Scene& scene, const ReadOptions& options, Mistakes& mistakes);

/// The coefficient where two shapes touch: `given`, or by the format's rule. Nothing where neither says one, or the two
/// directions have different ones.
std::optional<Rational> friction_between(const Scene& scene, const Shape& a, const Shape& b,
                                         const std::optional<Rational>& given);

/// Takes what a body is made of over to another that it is fixed to.
void add_to(Body& whole, const Body& part, bool is_ground = false);

/// Moves bodies with all that is on them; joints between them, and pushes on them, move along.
void move(Scene& scene, const std::vector<bool>& bodies, const Vector& by);

/// Adds a mistake for each element that only the mechanism in space can say.
void refuse_what_is_only_in_space(const Scene& scene, Mistakes& mistakes);

/// A body that two slides and a hinge hold to the ground is free in a plane: takes the joints and the massless links
/// between them out, with a note.
void join_planar_chains(Scene& scene);

/// A body that three slides along axes across each other hold to the ground moves freely, but does not turn: takes the
/// slides out, with a note, if they have neither friction nor an armature.
void join_free_slides(Scene& scene);

/// True if a joint connects two moving bodies, or the file excludes the pair. Their shapes then do not touch, as in the
/// engines of the formats; a body joined to the ground may touch it.
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
