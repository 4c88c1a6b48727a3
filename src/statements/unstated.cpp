#include "statements/unstated.hpp"

#include <algorithm>

namespace slipproof {

namespace {

std::string reason(const Setting& setting, const ClaimBody& body) {
  if (body.expect == Expectation::undecided) return "the claims file expects it to stay undecided";
  const auto* limit = std::get_if<Limit>(&body.says);
  if (limit != nullptr && body.expect == Expectation::refuted) return "statements cannot say that a limit is false";
  if (limit != nullptr && !limit->from) {
    return "a limit needs `from`: a value of " + limit->parameter + " from which on it can be shown";
  }
  const Modes named = modes(body.says);
  const auto lifts = [](ContactMode mode) { return !mode.on_road(); };
  if (!setting.scene.contains("J") && std::any_of(named.begin(), named.end(), lifts)) {
    return "a wheel off the road is not modelled without J in [setting.scene]";
  }
  if (body.expect == Expectation::refuted) return "statements cannot say how this claim fails";
  return "it would take too many cases";
}

}  // namespace

std::vector<UnstatedClaim> unstated_claims(const ClaimsFile& claims) {
  std::vector<UnstatedClaim> result;
  for (const Claim& claim : claims.claims) {
    for (const Reading reading : all_readings) {
      const bool printed = reading == Reading::printed;
      if (!printed && !claim.repaired) continue;
      if (!expected_statements(claims, claim, reading).empty()) continue;
      result.push_back(
          {claim.id + (printed ? "" : ".repaired"), reason(claims.settings[claim.setting], claim.body(reading))});
    }
  }
  return result;
}

}  // namespace slipproof
