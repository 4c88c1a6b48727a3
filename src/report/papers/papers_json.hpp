// What the JSON documents about papers share.
#pragma once

#include "claims/verify/certificates.hpp"
#include "report/papers/claim_counts.hpp"
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

/// Adds the counts; `judged` is the name of their sum.
inline void put_counts(Json& object, const char* judged, const ClaimCounts& counts) {
  object[judged] = counts.judged;
  object["proved"] = counts.proved;
  object["holds"] = counts.held;
  object["refuted"] = counts.refuted;
  object["undecided"] = counts.undecided;
  object["vacuous"] = counts.vacuous;
}

/// Adds the counts of claims as printed, and of our own.
inline void put_origins(Json& object, const char* judged, const CountsByOrigin& counts) {
  for (const Origin origin : all_origins) {
    put_counts(object[std::string(name(origin))], judged, counts[origin]);
  }
}

}  // namespace slipproof
