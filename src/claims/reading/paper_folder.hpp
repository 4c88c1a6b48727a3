// Finds which files in a folder and below it belong to a paper. One folder may have several claims files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slipproof {

/// Whether a TOML file declares that it is a claims file, even if it cannot be read as one.
bool is_claims_file(const std::filesystem::path& file);

/// The claims files of a folder, without those in its subfolders, by name; claims.toml comes first if it exists.
std::vector<std::filesystem::path> claims_files_in(const std::filesystem::path& folder);

struct PaperFolder {
  std::filesystem::path folder;
  /// The folder for files made from the claims: `certificates` for claims.toml and for the only claims file in a
  /// folder; NAME.certificates for NAME.toml if there are other claims files.
  std::string certificates = "certificates";

  /// Whether the figures and second opinions in the folder are about this paper.
  bool is_main() const { return certificates == "certificates"; }
  /// The folder for files made from the claims.
  std::filesystem::path generated() const { return folder / certificates; }
  /// Whether a file below the folder belongs to the paper. It does not if it is in a folder with claims files of its
  /// own, or in the `certificates` of another paper.
  bool owns(const std::filesystem::path& file) const;
};

/// The folder of a claims file.
PaperFolder paper_folder(const std::filesystem::path& claims);

}  // namespace slipproof
