// Checks certificate files, NAME.cert against NAME.statement beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slipproof::check {

struct FileResult {
  std::filesystem::path certificate;
  std::string verdict;  ///< `accepted`, `rejected`, or `unreadable`: a file is missing, or the statement malformed
  std::string theorem;  ///< empty where the statement cannot be read
  std::string message;  ///< `FILE:LINE: RULE: what is wrong`; empty when accepted
};

/// Checks one certificate. Never throws because of what the files contain.
FileResult check_file(const std::filesystem::path& certificate);

/// The certificates that an argument names: itself, or, for a folder, those of all statements in it and below, there or
/// not, in the order of their names.
std::vector<std::filesystem::path> certificates_in(const std::filesystem::path& argument);

struct Report {
  std::vector<FileResult> results;
  std::string text;     ///< a line for each result
  std::string summary;  ///< a line
  int exit_code = 0;    ///< 0 all accepted, 5 a certificate is rejected, 3 otherwise
};

Report check_files(const std::vector<std::string>& arguments);

}  // namespace slipproof::check
