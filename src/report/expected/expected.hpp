// What a physics engine should answer for a scene: all of its motions, and where they change, as data.
#pragma once

#include <string>
#include <vector>

#include "claims/uniqueness/expected_answer.hpp"

namespace slipproof {

/// Schema slipproof/expected/1 (cases/engines/README.md): one document, or for several scenes an array of them. Numbers
/// are exact, and the nearest binary64.
std::string expected_json(const std::vector<ExpectedAnswer>& answers);
/// A file for pytest: one test a scene, of a function accelerations(scene) that its user writes. Throws InputError for
/// a mechanism without bodies, which no engine can have.
std::string expected_pytest(const std::vector<ExpectedAnswer>& answers);

}  // namespace slipproof
