// What a physics engine should answer for a scene in space: its motions, whether it rests, and where that changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/space/solved_space.hpp"
#include "mechanics/planes/phase_diagram.hpp"

namespace slipproof {

/// Between two values of a parameter at which all motions are proved, or up to which rest is: other motions above than
/// below. Both are one value where it is known exactly.
struct ChangeInSpace {
  Rational lower, upper;
  MotionSet below, above;
};

struct ExpectedInSpace {
  std::string id;  ///< by which tests call the scene: its file's name without the extension
  SolvedSpace solved;
  std::optional<bool> can_rest, must_rest;  ///< nothing: undecided, or it moves already
  std::vector<ChangeInSpace> changes;       ///< along the parameter of the scene's [threshold], if it has one
};

/// Solves a scene in space and follows its threshold: motions are found at nine values, and where two neighbours
/// differ, at values between them. What changes and changes back between two neighbours that are alike is not seen.
/// Throws InputError as solve_space() does, and for a threshold that leaves the domain or at which not all motions are
/// found.
ExpectedInSpace expected_in_space(MechanismScene scene, const std::string& id);

}  // namespace slipproof
