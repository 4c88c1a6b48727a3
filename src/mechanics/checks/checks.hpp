// What is suspicious in a mechanism though it can be read: forces that do work against their own motion, rows of other
// scales, gravity that lifts, sums of different units, contacts that are not where the picture has them, and more.
#pragma once

#include <string>
#include <vector>

#include "mechanics/scene/scene.hpp"

namespace slipproof {

struct MechanismFinding {
  enum class Check { points, reciprocity, inertia, gravity, units, elements, geometry, names };
  Check check = Check::points;
  bool checkable = true;  ///< false: the check could not be made, and the message says why
  Place place;            ///< in the mechanism's file
  std::string message;
};

/// "FILE:LINE:COLUMN: warning: MESSAGE"; "FILE: not checkable: MESSAGE" without a place.
std::string to_string(const Mechanism& mechanism, const MechanismFinding& finding);

/// Runs all checks at sampled points of the domain, at least four. A correct mechanism has no finding.
std::vector<MechanismFinding> check_mechanism(const Mechanism& mechanism);

/// What is suspicious at the numbers of a scene: its drawing, and masses and inertias that its shapes cannot have.
/// Findings of check_mechanism() may be among these.
std::vector<MechanismFinding> check_numbers(const MechanismScene& scene);

}  // namespace slipproof
