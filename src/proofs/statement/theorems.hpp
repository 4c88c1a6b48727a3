// Theorem files (proofs/FORMAT.md): the statements and certificates of a claims file, concatenated. A part of
// FILE.theorems has the path FILE.theorems/NAME.statement, FILE.theorems/NAME.cert or FILE.theorems/claims.canonical,
// like a file in a folder.
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
  std::string certificate;  ///< the certificate, or undecided_text() with reasons; empty: nothing was tried
  std::size_t line = 0;     ///< the statement's first in the file
};

struct TheoremFile {
  std::string claims;  ///< canonical_claims(); may be empty
  std::vector<Theorem> theorems;

  /// Null if there is no theorem of that name.
  const Theorem* find(const std::string& name) const;
  std::string text() const;
};

/// Reads a theorem file. Throws InputError with the line.
TheoremFile read_theorems(const std::filesystem::path& file);

/// Whether a path is called NAME.theorems and is no folder. The file need not exist.
bool is_theorem_file(const std::filesystem::path& path);
/// The theorem file that the path names a part of; for all other paths the path itself.
std::filesystem::path file_of(const std::filesystem::path& path);

/// Reads texts by path: parts of theorem files, and other files. Caches each theorem file. May be used by several
/// threads.
class TheoremTexts {
 public:
  /// The text; nothing if there is no such part or regular file, or if it cannot be read.
  std::optional<std::string> at(const std::filesystem::path& path);
  /// The first line of a part in its file; 1 for a file of its own.
  std::size_t line_of(const std::filesystem::path& statement);

 private:
  const TheoremFile* read_once(const std::filesystem::path& file);

  std::mutex mutex_;
  std::map<std::filesystem::path, std::optional<TheoremFile>> files_;
};

}  // namespace slipproof
