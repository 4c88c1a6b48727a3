// Theorem files (proofs/FORMAT.md): all statements and certificates of a claims file after each other. A part of
// FILE.theorems has the path FILE.theorems/NAME.statement, FILE.theorems/NAME.cert or FILE.theorems/claims.canonical,
// so that it is named like a file in a folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace slipproof {

/// The name of the part with canonical_claims(), and of a file with them in a folder of statements.
inline constexpr const char* canonical_name = "claims.canonical";

struct Theorem {
  std::string name, statement;
  std::string certificate;  ///< or why there is none, as undecided_text() says it; empty: nothing was tried
  std::size_t line = 0;     ///< the statement's first in the file
};

struct TheoremFile {
  std::string claims;  ///< canonical_claims(); may be empty
  std::vector<Theorem> theorems;

  /// Nothing if there is no theorem of that name.
  const Theorem* find(const std::string& name) const;
  std::string text() const;
};

/// Reads a whole file. Throws InputError with the line.
TheoremFile read_theorems(const std::filesystem::path& file);

/// Whether a path is called NAME.theorems and is no folder. The file need not exist.
bool is_theorem_file(const std::filesystem::path& path);
/// The theorem file that the path names a part of; for all other paths the path itself.
std::filesystem::path file_of(const std::filesystem::path& path);

/// Reads texts by path: parts of theorem files, and other files. Keeps each theorem file in memory. May be used by
/// several threads.
class TheoremTexts {
 public:
  /// Nothing if there is no such part or regular file, or if it cannot be read.
  std::optional<std::string> at(const std::filesystem::path& path);
  /// The first line of a part in its file; 1 for a file of its own.
  std::size_t line_of(const std::filesystem::path& statement);

 private:
  const TheoremFile* whole(const std::filesystem::path& file);

  std::mutex mutex_;
  std::map<std::filesystem::path, std::optional<TheoremFile>> files_;
};

}  // namespace slipproof
