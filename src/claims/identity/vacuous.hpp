// Claims that say nothing, and motions that exist nowhere, with proofs that the certificate checker accepts.
#pragma once

#include "claims/identity/lemmas.hpp"

namespace slipproof {

/// Whether it is proved that the claim has a value at every bicycle and says nothing there (proofs/MEANING.md): its
/// region is empty, no force or motion is left in it, or its hypotheses contradict each other.
bool is_vacuous(const ClaimsFile& file, std::size_t claim, Reading reading, LemmaBook& book);

/// Whether it is proved that the motion that a claim of existence asserts exists nowhere.
bool is_nowhere(const ClaimsFile& file, std::size_t claim, Reading reading, LemmaBook& book);

}  // namespace slipproof
