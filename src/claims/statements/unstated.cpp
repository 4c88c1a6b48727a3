#include "claims/statements/unstated.hpp"

#include <algorithm>

#include "base/parallel/failure.hpp"

namespace slipproof {

namespace {

std::string reason(const Setting& setting, const ClaimBody& body) {
  if (body.expect == Expectation::undecided) return "the claims file expects it to stay undecided";
  if (std::string why = body.kind->why_unstated(body); !why.empty()) return why;
  const auto kinds = setting.kinds();
  for (const MechanismMode& mode : body.modes) {
    for (std::size_t i = 0; i < mode.size(); ++i) {
      const Mechanism& mechanism = *setting.mechanism;
      if (mode[i] == ElementState::slip && !has_state(kinds[i], mode[i])) {
        return "a slip of " + element_name(mechanism, i) +
               " from rest, in a direction that nobody knows before, is not modelled: `slipproof solve` finds it";
      }
      if (mode[i] != ElementState::lift || kinds[i].lifts) continue;
      const std::size_t needed = missing_for_lift(mechanism.contacts[i], setting.given()).front();
      return "lift of " + element_name(mechanism, i) + " is not modelled without " +
             mechanism.parameters[needed].symbol + " in [setting.scene]";
    }
  }
  if (body.kind->traits().of_all_motions && !std::ranges::all_of(kinds, &ElementKind::all_modelled)) {
    return "it is about all motions, and not all states of contacts are modelled";
  }
  if (body.expect == Expectation::refuted) return "statements cannot say how this claim fails";
  return "it would take too many cases or variables";
}

}  // namespace

std::vector<UnstatedClaim> unstated_claims(const ClaimsFile& claims) {
  std::vector<UnstatedClaim> result;
  for (const Claim& claim : claims.claims) {
    for (const Reading reading : all_readings) {
      const bool printed = reading == Reading::printed;
      if (!printed && !claim.repaired) continue;
      bool stated = false;
      const std::string failure = failure_of([&] { stated = !expected_statements(claims, claim, reading).empty(); });
      if (stated || !failure.empty()) continue;
      result.push_back(
          {claim.id + (printed ? "" : ".repaired"), reason(claims.settings[claim.setting], claim.body(reading))});
    }
  }
  return result;
}

}  // namespace slipproof
