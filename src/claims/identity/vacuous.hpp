// Claims that say nothing, and motions that are nowhere, with proofs that the certificate checker accepts.
#pragma once

#include "claims/identity/lemmas.hpp"

namespace slipproof {

/// Whether it is proved that the claim says something of no bicycle at all (proofs/MEANING.md): its region is empty, or
/// no force or motion is left in it, or its hypotheses contradict each other.
bool is_vacuous(const ClaimsFile& file, std::size_t claim, Reading reading, LemmaBook& book);

/// Whether it is proved that what a claim of existence seeks is nowhere.
bool is_nowhere(const ClaimsFile& file, std::size_t claim, Reading reading, LemmaBook& book);

}  // namespace slipproof
