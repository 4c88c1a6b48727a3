#include "claims/statements/claim_statements.hpp"

#include <map>

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

std::vector<NamedStatement> paper_statements(const ClaimsFile& claims) {
  std::vector<NamedStatement> result;
  std::map<std::string, const Claim*> claim_of;
  for (const Claim& claim : claims.claims) {
    for (const Reading reading : all_readings) {
      if (reading == Reading::repaired && !claim.repaired) continue;
      for (NamedStatement& statement : expected_statements(claims, claim, reading)) {
        const auto [other, is_new] = claim_of.emplace(statement.name, &claim);
        if (!is_new) {
          throw InputError({{claims.file, 0, 0,
                             "the claims " + other->second->id + " and " + claim.id + " both have a statement " +
                                 statement.name + ", expected ids whose statements have names of their own"}});
        }
        result.push_back(std::move(statement));
      }
    }
  }
  return result;
}

}  // namespace slipproof
