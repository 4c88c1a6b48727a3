// The text that the line numbers of a claims file refer to, where it is beside the file as numbered lines: `3. At a
// smooth wall ...`, and below them paragraphs on where they come from.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "claims/paper/paper.hpp"

namespace slipproof {

struct SourceLines {
  std::filesystem::path file;
  std::map<std::size_t, std::string> lines;  ///< by number, without it
  std::vector<std::string> about;            ///< the paragraphs below the lines
};

/// Nothing if the paper's source is not beside its claims file, or does not begin with a line `1. ...`. Throws
/// InputError if the file cannot be read.
std::optional<SourceLines> read_source_lines(const std::filesystem::path& claims, const Paper& paper);

}  // namespace slipproof
