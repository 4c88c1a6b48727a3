// The list of the kinds of claims.
#pragma once

#include <string_view>
#include <vector>

#include "claims/paper/claim_kind.hpp"

namespace slipproof {

/// All kinds, in the order in which messages list them.
const std::vector<const ClaimKind*>& claim_kinds();

/// Null if no kind has this name.
const ClaimKind* claim_kind(std::string_view name);

}  // namespace slipproof
