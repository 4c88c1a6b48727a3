// The places of the parts of a mechanism, from the coordinates in its file.
#pragma once

#include <string>
#include <vector>

#include "mechanics/scene/scene.hpp"
#include "report/picture/drawing.hpp"

namespace slipproof {

/// Shapes and contacts in numbers, in the units of the file, y up.
struct MechanismGeometry {
  struct Outline {
    MechanismShape::Kind kind;
    std::vector<Point> points;
    double radius = 0;
    std::string text;
  };
  struct Contact {
    std::size_t index;  ///< among the mechanism's contacts
    Point at;
    Point normal, along;  ///< of length 1; both 0 if unknown
  };
  /// What pushes a body, or turns it; at the scene's load, or at 1 or -1 where it has none.
  struct Push {
    Point at;
    Point along;       ///< of length 1; both 0 of a couple
    double size = 0;   ///< of the force, or of the couple, counterclockwise
    std::string name;  ///< as the file writes it
  };
  std::vector<Push> pushes;  ///< of bodies, those that are not 0
  std::vector<Outline> outlines;
  std::vector<Contact> contacts;  ///< only contacts that have a place
};

/// Throws InputError if a coordinate has no value in the scene.
MechanismGeometry geometry_of(const MechanismScene& scene);

}  // namespace slipproof
