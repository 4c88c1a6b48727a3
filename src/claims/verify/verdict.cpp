#include <algorithm>
#include <array>

#include "base/output/listed.hpp"
#include "claims/verify/verify.hpp"

namespace slipproof {

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 4> names{"holds", "refuted", "undecided", "vacuous"};
  return names[static_cast<std::size_t>(verdict)];
}

const ClaimResult* VerifyResult::find(const ClaimsFile& file, std::string_view id, Reading reading) const {
  for (const ClaimResult& result : claims) {
    if (file.claims[result.claim].id == id && result.reading == reading) return &result;
  }
  return nullptr;
}

std::string ClaimResult::identity_where() const {
  if (proved) return "";
  const std::string zeros = unless_zero.empty() ? "" : "these are not 0: " + listed(unless_zero);
  if (!unless_interval) return zeros;
  return "the domain of the force is one interval" + (zeros.empty() ? "" : " and " + zeros);
}

std::size_t ClaimResult::missing() const {
  return static_cast<std::size_t>(std::count_if(unproved.begin(), unproved.end(), [](const CheckedCertificate& c) {
    return c.state == CertificateState::missing;
  }));
}

std::size_t VerifyResult::missing() const {
  std::size_t all = 0;
  for (const ClaimResult& claim : claims) all += claim.missing();
  return all;
}

void yield_to_failure(ClaimResult& result) {
  if (result.failure.empty() || result.verdict == Verdict::refuted) return;
  result.verdict = Verdict::undecided;
  result.proved = false;
  result.certificates.clear();
}

bool as_expected(const ClaimsFile& file, const ClaimResult& result) {
  switch (file.claims[result.claim].body(result.reading).expect) {
    case Expectation::refuted:
      return result.verdict == Verdict::refuted;
    case Expectation::undecided:
      return result.verdict == Verdict::undecided;
    case Expectation::vacuous:
      return result.verdict == Verdict::vacuous;
    case Expectation::none:
    case Expectation::holds:
      break;
  }
  return result.verdict == Verdict::holds;
}

}  // namespace slipproof
