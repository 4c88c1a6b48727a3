// Claims as the judge that is proved in Coq reads them (proofs/coq/claim/Canonical.v): one line for each of the claims
// file and of its mechanisms, with inheritance, other readings and references to other claims carried out, so that a
// person can compare them.
#pragma once

#include <string>

#include "claims/paper/claims_file.hpp"

namespace slipproof {

/// All claims of the kinds that the judge knows, in each of their readings; the repaired one is called ID.repaired.
/// Leaves out claims of other kinds, and about mechanisms in space, whose cones of friction the judge does not know.
/// Linear in the length of the settings and claims.
std::string canonical_claims(const ClaimsFile& file);

}  // namespace slipproof
