// How the program's help looks: lines of at most 80 columns, and options in groups.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>

namespace slipproof::cli {

/// Names on the left, and what they do, their ranges and defaults on the right.
std::shared_ptr<CLI::Formatter> help_formatter();

/// Puts the options that many commands share into groups of their own: what is written, and how the work is done.
void group_options(CLI::App& command);

}  // namespace slipproof::cli
