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
  std::string name = "claims";  ///< of the claims file, without its extension
  bool is_main = true;          ///< whether the figures and second opinions in the folder are about this paper

  /// NAME.theorems: the file for what is made from the claims.
  std::filesystem::path theorems() const { return folder / (name + ".theorems"); }
  /// What earlier versions had instead: the folder `certificates`, or `NAME.certificates` of one that is not main.
  std::filesystem::path old_certificates() const;
  /// Of these two the one that exists; the file if there are both or none.
  std::filesystem::path generated() const;
  /// Whether a file below the folder, or a part of a theorem file, belongs to the paper. It does not if it is in a
  /// folder with claims files of its own, or made from the claims of another paper.
  bool owns(const std::filesystem::path& file) const;
};

/// The folder of a claims file.
PaperFolder paper_folder(const std::filesystem::path& claims);

}  // namespace slipproof
