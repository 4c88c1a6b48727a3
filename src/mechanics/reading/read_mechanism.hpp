// Mechanism files: reading (schema slipproof/mechanism/1).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// Reads a mechanism file. Throws InputError with every mistake of the file, in the order of their places. With
/// `impact` it is the impact of the mechanism, as it is with [impact] in the file.
Mechanism read_mechanism(const std::filesystem::path& path, std::optional<ImpactRequest> impact = {});

/// Reads a mechanism from a text; `file` is its name in messages. Safe for any bytes.
Mechanism parse_mechanism(std::string_view text, const std::string& file, std::optional<ImpactRequest> impact = {});
/// The same from a table of a file with that name.
Mechanism parse_mechanism(const TomlValue& table, const std::string& file, std::optional<ImpactRequest> impact = {});

}  // namespace slipproof
