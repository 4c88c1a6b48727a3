// Options that are numbers; --load of commands that answer at one load of a scene.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "mechanics/scene/scene.hpp"

namespace slipproof::cli {

/// An option's exact number. Throws CLI::ValidationError.
Rational number_of(const std::string& option, const std::string& text);

/// `load` stays empty without the option.
void add_load_option(CLI::App& command, std::string& load);
/// The scene at that load; as it is if it is empty. Throws CLI::ValidationError where it is no number, or the mechanism
/// has no load.
MechanismScene at_load(const MechanismScene& scene, const std::string& load);

}  // namespace slipproof::cli
