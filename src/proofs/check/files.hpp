// Checks certificates: NAME.cert against NAME.statement in the same folder or the same theorem file. A part of a
// theorem file has the path FILE.theorems/NAME.cert. judge.hpp decides; this finds and loads the texts and reports the
// results.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "proofs/check/theorem_file.hpp"
#include "proofs/check/verdict.hpp"

namespace slipproof::check {

/// The name of a file, in which a byte that cannot be shown is \xHH: otherwise it could pass for other lines.
std::string printable(const std::filesystem::path& path);

struct FileResult {
  std::filesystem::path certificate;
  Verdict verdict = Verdict::unreadable;
  std::string theorem;  ///< empty where the statement cannot be read
  /// `FILE:LINE: RULE: what is wrong`, or why undecided; empty when accepted. For a theorem file, the line is that in
  /// the whole file, and the name of the theorem follows.
  std::string message;
};

/// Checks certificates. Keeps the theorem file of the last one in memory. May be used by several threads.
class Checker {
 public:
  /// Never throws because of what the files contain or are; opens regular files only.
  FileResult check(const std::filesystem::path& certificate);

 private:
  std::shared_ptr<const TheoremFile> parts_of(const std::filesystem::path& file);
  FileResult check_part(const std::filesystem::path& certificate);

  std::mutex mutex_;
  std::filesystem::path last_;
  std::shared_ptr<const TheoremFile> parts_;  ///< of the last
};

FileResult check_file(const std::filesystem::path& certificate);

/// A part of a theorem file exactly: NAME.statement, NAME.cert, `claims.canonical`; NAME is both of the first.
struct Shown {
  std::string text;
  std::string problem;  ///< why there is none, if not empty
};
Shown show_part(const std::string& name, const std::filesystem::path& file);

/// The certificates that an argument names, in the order of their names: a certificate itself; for a statement its
/// certificate; for a folder or theorem file those of all statements in it and below, present or not, and those without
/// a statement. Links to files count as files. The result also has paths for check_file to report: those that cannot be
/// examined, such as a path that is too long, theorem files that cannot be split, folders that cannot be listed, and
/// links to folders elsewhere, which are not followed.
std::vector<std::filesystem::path> certificates_in(const std::filesystem::path& argument);

struct Report {
  std::vector<FileResult> results;
  std::string text;     ///< a line for each result
  std::string summary;  ///< a line
  int exit_code = 0;    ///< 0 all accepted, 5 some rejected; else 3 some unreadable or missing, 4 some undecided
};

Report check_files(const std::vector<std::string>& arguments);

}  // namespace slipproof::check
