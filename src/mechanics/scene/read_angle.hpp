// An angle in a scene file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/input/table_reader.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

/// A table { cos, sin }, { tan_half }, { tan } or { degrees }. Reports mistakes; a note says by how much the rational
/// angle differs from given degrees.
std::optional<MechanismValues::Circle> read_angle(const TomlValue& value, const std::string& name, Mistakes& mistakes,
                                                  std::vector<std::string>& notes);

}  // namespace slipproof
