// The list of the kinds of claims, in the order in which messages list them. A new kind is a file in this folder and a
// line here.
#define SLIPPROOF_CLAIM_KINDS(KIND) \
  KIND(interval)                    \
  KIND(impossible)                  \
  KIND(formula)                     \
  KIND(motions)                     \
  KIND(unique)                      \
  KIND(cover)                       \
  KIND(force_cover)                 \
  KIND(equivalence)                 \
  KIND(limit)                       \
  KIND(exists)                      \
  KIND(consequence)                 \
  KIND(system)

#include <algorithm>

#include "claims/paper/claim_kind.hpp"

namespace slipproof {

#define DECLARED(kind) const ClaimKind& kind##_kind();
SLIPPROOF_CLAIM_KINDS(DECLARED)

const std::vector<const ClaimKind*>& claim_kinds() {
#define LISTED(kind) &kind##_kind(),
  static const std::vector<const ClaimKind*> all{SLIPPROOF_CLAIM_KINDS(LISTED)};
  return all;
}

const ClaimKind* claim_kind(std::string_view name) {
  const auto found = std::find_if(claim_kinds().begin(), claim_kinds().end(),
                                  [&](const ClaimKind* kind) { return kind->name() == name; });
  return found == claim_kinds().end() ? nullptr : *found;
}

}  // namespace slipproof
