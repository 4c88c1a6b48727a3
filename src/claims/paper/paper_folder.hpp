// Which files in a folder, and below it, are a paper's: several claims files may stand in one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slipproof {

/// Whether a TOML file says that it is a claims file, readable as one or not.
bool is_claims_file(const std::filesystem::path& file);

/// Those of a folder, without the folders in it, in the order of their names; claims.toml, if it is there, comes first.
std::vector<std::filesystem::path> claims_files_in(const std::filesystem::path& folder);

struct PaperFolder {
  std::filesystem::path folder;
  /// The folder in it for what is made of the claims: `certificates` of claims.toml, and of the only claims file there
  /// is; NAME.certificates of a NAME.toml that stands beside others.
  std::string certificates = "certificates";

  /// Whether figures and second opinions that stand there are about this paper.
  bool is_main() const { return certificates == "certificates"; }
  /// The folder for what is made of the claims.
  std::filesystem::path generated() const { return folder / certificates; }
  /// Whether a file below the folder belongs to the paper. Others are in a folder in which claims files of their own
  /// stand, or that is another paper's `certificates`.
  bool owns(const std::filesystem::path& file) const;
};

/// That of a claims file.
PaperFolder paper_folder(const std::filesystem::path& claims);

}  // namespace slipproof
