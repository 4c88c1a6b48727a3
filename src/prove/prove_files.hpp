// Many statements at once: files in, certificates out.
#pragma once

#include <filesystem>
#include <vector>

#include "prove/prove.hpp"

namespace slipproof {

/// The statements in a folder and the folders in it, in the order of their names.
std::vector<std::filesystem::path> statements_in(const std::filesystem::path& folder);

/// Proves each; the outcomes in the order of the files, the same at any number of threads (0: all cores). Throws
/// InputError for a file that cannot be read or is no statement.
std::vector<ProofOutcome> prove_files(const std::vector<std::filesystem::path>& statements, unsigned threads = 0);

}  // namespace slipproof
