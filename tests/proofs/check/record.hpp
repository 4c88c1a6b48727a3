// What the checker is asked in these tests, for another checker to judge alike.
#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

#include "proofs/check/verdict.hpp"

namespace slipproof::check {

/// Adds `VERDICT S C`, the S bytes of the statement and the C bytes of the certificate to the file, or pipe, that
/// SLIPPROOF_CHECK_RECORD names, if it names one.
inline void record(const std::string& statement, const std::string& certificate, Verdict verdict) {
  static const char* const path = std::getenv("SLIPPROOF_CHECK_RECORD");
  if (path == nullptr) return;
  static std::ofstream file(path, std::ios::binary);
  file << to_string(verdict) << ' ' << statement.size() << ' ' << certificate.size() << '\n'
       << statement << certificate;
}

}  // namespace slipproof::check
