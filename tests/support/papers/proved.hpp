// Whether the search finds a proof of a statement that was made of a claim.
#pragma once

#include "proofs/search/prove.hpp"
#include "proofs/statement/statement_text.hpp"

namespace slipproof::test {

inline ProofOutcome::Verdict proved(const NamedStatement& statement) {
  prove::Limits limits;
  limits.steps = 1'000'000;
  return prove_statement(statement.name, statement.text, limits).verdict;
}

}  // namespace slipproof::test
