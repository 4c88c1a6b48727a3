// To add a kind, add a file to this folder and its name to both lists.
#include "claims/kinds/kinds.hpp"

#include <algorithm>

namespace slipproof {

const ClaimKind &interval_kind(), &impossible_kind(), &formula_kind(), &motions_kind(), &unique_kind(), &cover_kind(),
    &force_cover_kind(), &equivalence_kind(), &limit_kind(), &exists_kind(), &consequence_kind(), &system_kind();

const std::vector<const ClaimKind*>& claim_kinds() {
  static const std::vector<const ClaimKind*> all{
      &interval_kind(),    &impossible_kind(),  &formula_kind(), &motions_kind(), &unique_kind(),      &cover_kind(),
      &force_cover_kind(), &equivalence_kind(), &limit_kind(),   &exists_kind(),  &consequence_kind(), &system_kind()};
  return all;
}

const ClaimKind* claim_kind(std::string_view name) {
  const auto found = std::find_if(claim_kinds().begin(), claim_kinds().end(),
                                  [&](const ClaimKind* kind) { return kind->name() == name; });
  return found == claim_kinds().end() ? nullptr : *found;
}

}  // namespace slipproof
