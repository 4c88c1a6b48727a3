// What a physics engine should answer for a scene: all of its motions, and where they change, as data.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "claims/uniqueness/expected_answer.hpp"
#include "contact/space/solved_space.hpp"

namespace slipproof {

/// The same of a scene in space.
struct ExpectedInSpace {
  std::string id;
  SolvedSpace solved;
};
using Expected = std::variant<ExpectedAnswer, ExpectedInSpace>;

/// Throws InputError for a [threshold], which can be followed in the plane only.
void refuse_threshold(const MechanismScene& scene, const std::string& id);

/// Schema slipproof/expected/1 (cases/engines/README.md): one document, or for several scenes an array of them. Numbers
/// are exact, and the nearest binary64; in space they may be ranges that are proved to hold them.
std::string expected_json(const std::vector<Expected>& answers);
/// A file for pytest: one test a scene, of a function accelerations(scene) that its user writes. Throws InputError for
/// a mechanism without bodies, which no engine can have, and for a scene in space of which a test would need to know
/// more: all of its motions, each alone.
std::string expected_pytest(const std::vector<Expected>& answers);

}  // namespace slipproof
