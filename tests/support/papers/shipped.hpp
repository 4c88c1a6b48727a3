// The shipped paper, for tests.
#pragma once

#include <filesystem>

#include "claims/reading/read_claims_file.hpp"

namespace slipproof::test {

inline const std::filesystem::path shipped_folder = SLIPPROOF_SOURCE_DIR "/proofs/rozenblat-yashin";
inline const std::filesystem::path shipped_certificates = shipped_folder / "claims.theorems";

inline const ClaimsFile& shipped_paper() {
  static const ClaimsFile file = read_claims(shipped_folder / "claims.toml");
  return file;
}

inline std::size_t index_of(const ClaimsFile& file, std::string_view id) {
  return static_cast<std::size_t>(file.find(id) - file.claims.data());
}

/// The setting of section 3, in which the Assertions are stated.
inline std::size_t section_3(const ClaimsFile& file) {
  return file.find("A1.1")->setting;
}

}  // namespace slipproof::test
