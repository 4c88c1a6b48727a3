// Options of several commands: --load of commands that answer at one load of a scene, ranges, limits, --from, --law.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/scene/scene.hpp"

namespace slipproof::cli {

/// An option's exact number. Throws CLI::ValidationError.
Rational number_of(const std::string& option, const std::string& text);

/// An option of two numbers, FROM TO; its texts stay empty without it.
void add_range_option(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
                      const std::string& description);
/// Its ends; nothing without it.
std::array<std::optional<Rational>, 2> range_of(const std::vector<std::string>& texts);

/// `load` stays empty without the option.
void add_load_option(CLI::App& command, std::string& load);
/// --from: where to look at a scene in space from; stays empty without the option.
void add_view_option(CLI::App& command, std::string& from);
/// In space, of each place of a map or along a parameter.
void add_place_effort_option(CLI::App& command, std::uint64_t& effort);

/// --law: an impact's; stays empty without the option. `otherwise`: by what law impacts are without it.
void add_law_option(CLI::App& command, std::string& law, const std::string& otherwise);

/// The scene at that load; as it is if it is empty. Throws CLI::ValidationError where it is no number, or the mechanism
/// has no load.
MechanismScene at_load(const MechanismScene& scene, const std::string& load);

}  // namespace slipproof::cli
