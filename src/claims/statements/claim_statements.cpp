#include "claims/statements/claim_statements.hpp"

#include "base/input/diagnostic.hpp"
#include "claims/statements/claim_writer.hpp"

namespace slipproof {

std::vector<NamedStatement> claim_statements(const ClaimsFile& claims, const Claim& claim, Reading reading) {
  ClaimWriter writer(claims, claim, reading);
  writer.body().kind->state(writer);
  return writer.take();
}

std::vector<NamedStatement> claim_refutation(const ClaimsFile& claims, const Claim& claim, Reading reading) {
  ClaimWriter writer(claims, claim, reading);
  writer.body().kind->refute(writer);
  return writer.take();
}

std::vector<NamedStatement> expected_statements(const ClaimsFile& claims, const Claim& claim, Reading reading) {
  const Expectation expect = claim.body(reading).expect;
  if (expect == Expectation::undecided) return {};
  return expect == Expectation::refuted ? claim_refutation(claims, claim, reading)
                                        : claim_statements(claims, claim, reading);
}

void StatementNames::add(const Claim& claim, const std::vector<NamedStatement>& statements) {
  for (const NamedStatement& statement : statements) {
    const Claim* other = claim_of_.emplace(statement.name, &claim).first->second;
    if (other == &claim) continue;
    throw InputError({{claims_.file, 0, 0,
                       "the claims " + other->id + " and " + claim.id + " both have a statement " + statement.name +
                           ", expected ids whose statements have names of their own"}});
  }
}

}  // namespace slipproof
