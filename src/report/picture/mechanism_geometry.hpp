// Where the parts of a mechanism are, by the coordinates of its file.
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
    std::size_t index;  ///< among the mechanism's
    Point at;
    Point normal, along;  ///< of length 1, or both 0: not known
  };
  std::vector<Outline> outlines;
  std::vector<Contact> contacts;  ///< those that have a place
};

/// Throws InputError for a coordinate that has no value at the scene.
MechanismGeometry geometry_of(const MechanismScene& scene);

}  // namespace slipproof
