// A paper as data: its symbols, its definitions, and its claims about the model. proofs/CLAIMS.md describes the file
// for authors; claims/reading reads it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "claims/paper/claim.hpp"
#include "claims/paper/paper.hpp"
#include "claims/paper/setting.hpp"

namespace slipproof {

struct ClaimsFile {
  std::string file;
  Paper paper;
  std::vector<Setting> settings;
  std::vector<Claim> claims;
  std::vector<Unchecked> unchecked;

  const Claim* find(std::string_view id) const;
};

/// The file with one reading only, as `printed`. In the repaired reading, what has no repair stays as printed.
ClaimsFile as_read(const ClaimsFile& file, Reading reading);

}  // namespace slipproof
