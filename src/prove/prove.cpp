#include "prove/prove.hpp"

namespace slipproof {

ProofOutcome prove_statement(const std::string& file, const std::string& text, const prove::Limits& limits) {
  const prove::Statement statement(file, text);
  prove::Search search(statement, limits);
  ProofOutcome outcome{statement.theorem(), {}, {}};
  if (const auto proof = search.prove()) {
    outcome.certificate = prove::certificate_text(statement, *proof);
  } else {
    outcome.leftover = search.leftover().facts;
  }
  return outcome;
}

}  // namespace slipproof
