#include "claims/paper/claims_file.hpp"

#include <algorithm>

namespace slipproof {

const Claim* ClaimsFile::find(std::string_view id) const {
  const auto found = std::find_if(claims.begin(), claims.end(), [&](const Claim& claim) { return claim.id == id; });
  return found == claims.end() ? nullptr : &*found;
}

ClaimsFile as_read(const ClaimsFile& file, Reading reading) {
  ClaimsFile result = file;
  for (Setting& setting : result.settings) {
    for (Definition& definition : setting.definitions) {
      if (reading == Reading::repaired && definition.repaired) definition.printed = definition.repaired;
      definition.repaired = nullptr;
      definition.why.clear();
    }
  }
  for (Claim& claim : result.claims) {
    claim.printed = ClaimBody(claim.body(reading));
    claim.repaired.reset();
    claim.why.clear();
  }
  return result;
}

}  // namespace slipproof
