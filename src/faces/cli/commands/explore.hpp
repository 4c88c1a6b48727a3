// The explorer's page for the pages of reports.
#pragma once

#include <filesystem>
#include <string>

#include "base/output/output_file.hpp"

namespace slipproof::cli {

/// Where `./run explorer` has written the explorer's page, if it has.
std::filesystem::path explorer_file();

/// Copies the explorer's page into a folder of pages. Returns its name there; empty if it is not built.
std::string copy_explorer(const OutputFolder& pages);

}  // namespace slipproof::cli
