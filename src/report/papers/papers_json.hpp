// What the JSON documents about papers share.
#pragma once

#include "claims/verify/certificates.hpp"
#include "report/papers/tally.hpp"
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
inline void put_tally(Json& object, const char* judged, const Tally& tally) {
  object[judged] = tally.judged;
  object["proved"] = tally.proved;
  object["holds"] = tally.held;
  object["refuted"] = tally.refuted;
  object["undecided"] = tally.undecided;
  object["vacuous"] = tally.vacuous;
}

/// Adds the counts of claims as printed, and of our own.
inline void put_origins(Json& object, const char* judged, const Tallies& tallies) {
  for (const Origin origin : all_origins) {
    put_tally(object[std::string(name(origin))], judged, tallies[origin]);
  }
}

}  // namespace slipproof
