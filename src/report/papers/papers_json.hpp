// A second checker in JSON documents.
#pragma once

#include "claims/verify/certificates.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

inline Json to_json(const SecondChecker& checker) {
  Json entry{{"name", checker.name}, {"accepted", checker.accepted}};
  if (checker.from_claims > 0) {
    entry["from_the_claim_on"] = checker.from_claims;
    entry["from_statements_only"] = checker.from_statements;
  }
  return entry;
}

}  // namespace slipproof
