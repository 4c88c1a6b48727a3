// Claims without statements. `prove` reports which they are, and why.
#pragma once

#include <string>
#include <vector>

#include "claims/statements/claim_statements.hpp"

namespace slipproof {

struct UnstatedClaim {
  std::string id;  ///< with `.repaired` in that reading, as in the names of statements
  std::string why;
};

/// The claims, in each reading, that have no expected_statements().
std::vector<UnstatedClaim> unstated_claims(const ClaimsFile& claims);

}  // namespace slipproof
