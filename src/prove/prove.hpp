// Proofs for all parameters: from a statement to a certificate. Nothing here is trusted; check/ judges what comes out.
#pragma once

#include <string>
#include <vector>

#include "prove/search.hpp"

namespace slipproof {

/// What came of a search for a proof.
struct ProofOutcome {
  std::string theorem;
  std::string certificate;            ///< its text; empty where no proof was found
  std::vector<std::string> leftover;  ///< otherwise: the sign conditions that the search could not refute

  bool proved() const { return !certificate.empty(); }
};

/// Searches for a proof of the statement in `text`, the content of `file`. Deterministic. Throws InputError.
ProofOutcome prove_statement(const std::string& file, const std::string& text, const prove::Limits& limits = {});

}  // namespace slipproof
