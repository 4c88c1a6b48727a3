// The kinds of claims that there are.
#pragma once

#include <string_view>
#include <vector>

#include "claims/paper/claim_kind.hpp"

namespace slipproof {

/// In the order in which messages list them.
const std::vector<const ClaimKind*>& claim_kinds();

/// Null: there is no kind of this name.
const ClaimKind* claim_kind(std::string_view name);

}  // namespace slipproof
