// Options with exact numbers: --load of commands that answer at one load of a scene, and ranges.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/scene/scene.hpp"

namespace slipproof::cli {

/// `load` stays empty without the option.
void add_load_option(CLI::App& command, std::string& load);
/// The scene at that load; as it is if it is empty. Throws CLI::ValidationError where it is no number, or the mechanism
/// has no load.
MechanismScene at_load(const MechanismScene& scene, const std::string& load);

/// An option with two numbers, FROM TO.
void add_range_option(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
                      const std::string& help);
/// The ends of such a range; nothing where it is not given.
void set_range(const std::vector<std::string>& texts, std::optional<Rational>& from, std::optional<Rational>& to);

}  // namespace slipproof::cli
