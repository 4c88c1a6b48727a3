// Claims of which no statement is made: whoever proves a paper is told which, and why.
#pragma once

#include <string>
#include <vector>

#include "claims/statements/claim_statements.hpp"

namespace slipproof {

struct UnstatedClaim {
  std::string id;  ///< with `.repaired` in that reading, as statements are named
  std::string why;
};

/// The claims, in each reading, of which there are no expected_statements().
std::vector<UnstatedClaim> unstated_claims(const ClaimsFile& claims);

}  // namespace slipproof
