// Shipped files that a test makes again.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/run_program.hpp"

namespace slipproof::test {

/// Whether the file has these contents. SLIPPROOF_WRITE_TABLE, if set, writes it anew.
inline bool is_made_again(const std::filesystem::path& file, const std::string& contents) {
  if (std::getenv("SLIPPROOF_WRITE_TABLE") != nullptr) std::ofstream(file, std::ios::binary) << contents;
  return contents == read_file(file);
}

}  // namespace slipproof::test
