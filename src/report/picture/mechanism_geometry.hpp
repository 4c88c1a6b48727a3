// The places of the parts of a mechanism, from the coordinates in its file.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/scene/scene.hpp"
#include "report/picture/drawing.hpp"

namespace slipproof {

/// Shapes and contacts in numbers, in the units of the file, y up; turned so that gravity, where a scene of bodies has
/// it, points down.
struct MechanismGeometry {
  struct Outline {
    MechanismShape::Kind kind;
    std::vector<Point> points;
    double radius = 0;  ///< of a turn, clockwise if negative
    std::string text;
    bool thin = false;
    /// The bodies, among the scene's, that its first point and its other points move with.
    std::optional<std::array<std::size_t, 2>> bodies = std::nullopt;
  };
  struct Contact {
    std::size_t index;  ///< among the mechanism's contacts
    Point at;
    Point normal, along;  ///< of length 1; both 0 if unknown
  };
  /// What pushes a body, or turns it: a force or couple of the file, its reaction, a spring, or an arrow that has the
  /// load's symbol as a label at one end; at the scene's load, or at 1 or -1 where it has none.
  struct Push {
    Point at;
    Point along;          ///< of length 1; both 0 of a couple
    double size = 0;      ///< of the force, or of the couple, counterclockwise
    std::string name;     ///< as the file writes it, without its sign
    std::string value;    ///< of what is called so: `= 3`; empty where the name is a number, or the load has no value
    bool begins = false;  ///< the arrow begins at the place, and does not end there
  };
  /// An acceleration that an arrow of the file shows.
  struct Acceleration {
    Point at;
    Point along;        ///< of length 1, where it is positive
    std::size_t index;  ///< among acceleration_names()
    std::string name;
  };
  struct Weight {
    Point at;
    double size = 0;
    std::optional<Rational> exact;  ///< nothing: no rational number
    std::string body;
  };
  /// How a body moves before the motion.
  struct Movement {
    Point at;
    Point velocity;   ///< of its centre of mass
    double spin = 0;  ///< counterclockwise
    std::string body;
  };
  std::vector<Outline> outlines;
  std::vector<Contact> contacts;  ///< only contacts that have a place
  std::vector<Push> pushes;       ///< those that are not 0
  std::vector<Acceleration> accelerations;
  std::vector<Weight> weights;  ///< of bodies, downwards
  std::vector<Movement> movements;
  double turned = 0;  ///< by this angle, counterclockwise
};

/// With the shapes that are `still` if no motion is drawn. Throws InputError if a coordinate has no value in the scene.
MechanismGeometry geometry_of(const MechanismScene& scene, bool still);

/// The least distance of two contacts that is larger than `fused`; infinite if there is none.
double least_distance(const MechanismGeometry& geometry, double fused);

}  // namespace slipproof
