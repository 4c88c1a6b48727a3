// Checks certificate files: NAME.cert against NAME.statement beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slipproof::check {

enum class Verdict { accepted, rejected, unreadable };

struct FileResult {
  std::filesystem::path certificate;
  std::string theorem;  ///< empty where the statement cannot be read
  Verdict verdict = Verdict::unreadable;
  std::string message;  ///< `FILE:LINE: RULE: what is wrong`; empty when accepted
};

/// Checks one certificate. Never throws because of what the files contain.
FileResult check_file(const std::filesystem::path& certificate);

/// The certificates that an argument names: itself, or, for a folder, those of all statements in it and below, whether
/// the certificates are there or not, in the order of their names.
std::vector<std::filesystem::path> certificates_in(const std::filesystem::path& argument);

}  // namespace slipproof::check
