// The places of the parts of a scene in space, from the bodies in its file.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mechanics/bodies/bodies.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/picture/scene_numbers.hpp"
#include "report/picture/space/solid.hpp"

namespace slipproof {

/// In numbers, in the units and the axes of the file.
struct SpaceGeometry {
  struct PlacedSolid {
    std::size_t body = 0;
    Solid solid;
  };
  /// What has no shape: from its centre of mass to each of its points.
  struct Stick {
    std::size_t body = 0;
    Vec3 from{}, to{};
  };
  struct Contact {
    std::size_t index = 0;  ///< among the mechanism's contacts
    Vec3 at{}, normal{}, first{}, second{};
    double mu = 0;
    std::size_t of = 0;                ///< the body on which its forces push
    std::optional<std::size_t> plane;  ///< that it touches
  };
  /// A plane that bodies touch.
  struct Plane {
    std::size_t on = ground;
    Vec3 through{}, normal{};
  };
  struct Joint {
    BodyJoint::Kind kind = BodyJoint::Kind::ball;
    std::string name;  ///< empty where its contact has it
    Vec3 at{}, to{};   ///< the same where its ends meet
    std::vector<Vec3> axes;
  };
  struct Push {
    Vec3 at{}, is{};
    bool couple = false;
    std::string name, value;  ///< as MechanismGeometry::Push
  };
  struct Weight {
    Vec3 at{}, is{};
    std::string body;
  };
  struct MovingBody {
    Vec3 at{}, velocity{}, spin{};
    std::string name;
    /// The unknown of each of its six accelerations with its sign, or 0 and what is prescribed.
    std::array<std::pair<std::size_t, double>, 6> unknowns{};
    std::array<double, 6> prescribed{};
  };
  std::vector<PlacedSolid> solids;
  std::vector<Stick> sticks;
  std::vector<Contact> contacts;  ///< those that have a place
  std::vector<Plane> planes;
  std::vector<Joint> joints;
  std::vector<Push> pushes;
  std::vector<Weight> weights;
  std::vector<MovingBody> bodies;  ///< without the ground
  Vec3 up{0, 0, 1};                ///< against gravity, where there is some
  bool has_units = false;          ///< m, s, kg
  bool is_impact = false;          ///< what would be accelerations are velocities after it, and forces impulses
};

/// Throws InputError if a coordinate has no value in the scene.
SpaceGeometry space_geometry(const MechanismScene& scene);

}  // namespace slipproof
