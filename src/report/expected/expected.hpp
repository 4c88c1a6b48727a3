// What a physics engine should answer for a scene: all of its motions, and where they change, as data.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "claims/uniqueness/expected_answer.hpp"
#include "claims/uniqueness/expected_impact.hpp"
#include "claims/uniqueness/expected_in_space.hpp"

namespace slipproof {

using Expected = std::variant<ExpectedAnswer, ExpectedInSpace, ExpectedImpact>;

/// Solves a scene without an impact. Throws InputError as expected_answer() and expected_in_space() do.
Expected expected_of(MechanismScene scene, const std::string& id);
/// Solves the scene in a file: an impact, or one in the plane or in space. Throws InputError as read_scene(),
/// expected_impact(), expected_answer() and expected_in_space() do.
Expected expected_of(const std::filesystem::path& file, const std::string& id);
/// Its scene.
const MechanismScene& scene_of(const Expected& expected);

/// Schema slipproof/expected/1 (cases/engines/README.md): one document, or for several scenes an array of them. Numbers
/// are exact, and the nearest binary64; in space they may be ranges that are proved to hold them.
std::string expected_json(const std::vector<Expected>& answers);
/// A file for pytest: one test a scene, of a function accelerations(scene) that its user writes. Throws InputError for
/// a mechanism without bodies, which no engine can have, for an impact, and for a scene in space of which a test would
/// need to know more: all of its motions, each alone.
std::string expected_pytest(const std::vector<Expected>& answers);

}  // namespace slipproof
