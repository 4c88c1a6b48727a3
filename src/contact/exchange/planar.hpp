// A scene seen from the side as a mechanism of bodies (cases/mechanisms/bodies/README.md).
#pragma once

#include <string>
#include <vector>

#include "contact/exchange/touch.hpp"

namespace slipproof::imported {

struct PlanarOptions : TouchOptions {
  std::string plane;  ///< `xz`, `yz`, `xy`; empty: the first in which everything lies
};

struct PlanarMechanism {
  std::string text;                       ///< contents of the mechanism's file
  std::vector<std::string> import_notes;  ///< remarks: parts that were left out, moved, turned or assumed
  std::string plane;
  std::size_t contacts = 0;
};

/// Bodies stand along the scene's axes, in numbers: each point is where it is now. Shapes that touch make contacts: a
/// corner or a disc on a line, at the place where it is, a disc on a disc. Throws InputError where the scene does not
/// lie in a plane, shapes are inside each other, or a contact is of another kind. Quadratic in the number of shapes.
PlanarMechanism to_planar(Scene scene, const PlanarOptions& options);

}  // namespace slipproof::imported
