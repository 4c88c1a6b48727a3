// Checks certificate files, NAME.cert against NAME.statement in the same folder. judge.hpp decides; this finds and
// loads the files and reports the results.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "proofs/check/verdict.hpp"

namespace slipproof::check {

/// The name of a file, in which a byte that cannot be shown is \xHH: otherwise it could pass for other lines.
std::string printable(const std::filesystem::path& path);

struct FileResult {
  std::filesystem::path certificate;
  Verdict verdict = Verdict::unreadable;
  std::string theorem;  ///< empty where the statement cannot be read
  std::string message;  ///< `FILE:LINE: RULE: what is wrong`, or why undecided; empty when accepted
};

/// Checks one certificate. Never throws because of what the files contain or are; opens regular files only.
FileResult check_file(const std::filesystem::path& certificate);

/// The certificates that an argument names, in the order of their names: a certificate itself; for a statement its
/// certificate; for a folder those of all statements in it and below, present or not, and those without a statement.
/// Links to files count as files. The result also has paths for check_file to report: those that cannot be examined,
/// such as a path that is too long, folders that cannot be listed, and links to folders elsewhere, which are not
/// followed.
std::vector<std::filesystem::path> certificates_in(const std::filesystem::path& argument);

struct Report {
  std::vector<FileResult> results;
  std::string text;     ///< a line for each result
  std::string summary;  ///< a line
  int exit_code = 0;    ///< 0 all accepted, 5 some rejected; else 3 some unreadable or missing, 4 some undecided
};

Report check_files(const std::vector<std::string>& arguments);

}  // namespace slipproof::check
