// What a physics engine should answer for a scene: all of its motions, and where they change, as data.
#pragma once

#include <string>
#include <vector>

#include "claims/uniqueness/motion_changes.hpp"
#include "report/scenes/mechanism_report.hpp"

namespace slipproof {

struct ExpectedAnswer {
  std::string id;                     ///< by which tests call the scene: its file's name without the extension
  SolvedMechanism solved;             ///< with its motions at the load
  std::vector<MotionChange> changes;  ///< along the parameter of the scene's [threshold], if it has one
};

/// Solves a scene and follows its threshold. Throws InputError for a load without a value, and for a threshold that
/// cannot be followed.
ExpectedAnswer expected_answer(MechanismScene scene, const std::string& id);

/// Schema slipproof/expected/1 (cases/engines/README.md): one document, or for several scenes an array of them. Numbers
/// are exact, and the nearest binary64.
std::string expected_json(const std::vector<ExpectedAnswer>& answers);
/// A file for pytest: one test a scene, of a function accelerations(scene) that its user writes. Throws InputError for
/// a mechanism without bodies, which no engine can have.
std::string expected_pytest(const std::vector<ExpectedAnswer>& answers);

}  // namespace slipproof
