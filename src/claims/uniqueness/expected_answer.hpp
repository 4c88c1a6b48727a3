// What a physics engine should answer for a scene: all of its motions, and where they change.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/problem/every_load.hpp"
#include "mechanics/lines/motion_changes.hpp"
#include "mechanics/scene/solved_mechanism.hpp"

namespace slipproof {

struct ExpectedAnswer {
  std::string id;                     ///< by which tests call the scene: its file's name without the extension
  SolvedMechanism solved;             ///< with its motions at the load
  std::optional<EveryLoad> every_q;   ///< whether it has one motion whatever else pushes it (for_every_push())
  std::vector<MotionChange> changes;  ///< along the parameter of the scene's [threshold], if it has one
};

/// Solves a scene and follows its threshold. Throws InputError for a load without a value, and for a threshold that
/// cannot be followed.
ExpectedAnswer expected_answer(MechanismScene scene, const std::string& id);

}  // namespace slipproof
