// A scene as a mechanism in space (`dimension = 3`).
#pragma once

#include <string>
#include <vector>

#include "contact/exchange/shapes/spatial_contacts.hpp"

namespace slipproof::imported {

struct SpaceOptions : TouchOptions {
  Overlaps overlaps = Overlaps::within_one_robot;
  bool stand = false;  ///< moves each robot that nothing holds up or down, until it touches the ground
};

struct SpaceMechanism {
  std::string text;                       ///< contents of the mechanism's file, in numbers
  std::vector<std::string> import_notes;  ///< remarks: parts that were left out, moved, turned or assumed
  std::size_t bodies = 0, contacts = 0;
};

/// Bodies stand along the scene's axes, as they are now. Massless links stand between the joints of one body.
/// Shapes that touch make contacts, each moved to where the surfaces meet. Throws InputError for shapes of different
/// robots that overlap, or touch in a way that is not read.
SpaceMechanism to_space(Scene scene, const SpaceOptions& options);

}  // namespace slipproof::imported
