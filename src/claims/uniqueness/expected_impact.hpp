// What a physics engine may answer to an impact: its outcomes by each law.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "contact/impact/solved_impact.hpp"

namespace slipproof {

struct ExpectedImpact {
  std::string id;                  ///< by which tests call the scene: its file's name without the extension
  std::vector<SolvedImpact> laws;  ///< by that of the file first

  const MechanismScene& scene() const { return laws.front().scene; }
};

/// Of the scene in a file whose mechanism is an impact. Throws InputError as read_scene() and solve_impact() do.
ExpectedImpact expected_impact(const std::filesystem::path& file, const std::string& id);

}  // namespace slipproof
