#include "report/papers/claim_counts.hpp"

#include <fmt/format.h>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"

namespace slipproof {

namespace {

/// `17 claims of our own were judged: 16 are proved for all parameters, 1 is refuted.`
std::string sentence_of(const ClaimCounts& t, std::string_view whose, std::string_view judged) {
  if (t.judged == 0) return {};
  std::string parts;
  const auto part = [&](std::size_t n, const char* one, const char* many, const std::string& ids = "") {
    if (n == 0) return;
    parts += fmt::format("{}{} {}{}", parts.empty() ? "" : ", ", n, n == 1 ? one : many,
                         ids.empty() ? "" : " (" + ids + ")");
  };
  part(t.proved, "is proved for all parameters", "are proved for all parameters");
  part(t.held, "holds at every sample", "hold at every sample");
  part(t.refuted, "is refuted", "are refuted");
  part(t.undecided.size(), "is undecided", "are undecided", listed(t.undecided));
  part(t.vacuous.size(), "is vacuous", "are vacuous", listed(t.vacuous));
  return fmt::format("{}{} {} {}: {}.", counted(t.judged, "claim"), whose, t.judged == 1 ? "was" : "were", judged,
                     parts);
}

}  // namespace

void ClaimCounts::add(const ClaimCounts& other) {
  judged += other.judged, proved += other.proved, held += other.held, refuted += other.refuted;
  undecided.insert(undecided.end(), other.undecided.begin(), other.undecided.end());
  vacuous.insert(vacuous.end(), other.vacuous.begin(), other.vacuous.end());
}

ClaimCounts CountsByOrigin::all() const {
  ClaimCounts sum = printed;
  sum.add(ours);
  return sum;
}

CountsByOrigin count_claims(const ClaimsFile& file, const VerifyResult& result) {
  CountsByOrigin counts;
  for (const ClaimResult& r : result.claims) {
    if (r.reading != Reading::printed) continue;
    const Claim& claim = file.claims[r.claim];
    ClaimCounts& t = counts[claim.origin];
    ++t.judged;
    switch (r.verdict) {
      case Verdict::holds:
        ++(r.proved ? t.proved : t.held);
        break;
      case Verdict::refuted:
        ++t.refuted;
        break;
      case Verdict::undecided:
        t.undecided.push_back(claim.id);
        break;
      case Verdict::vacuous:
        t.vacuous.push_back(claim.id);
        break;
    }
  }
  return counts;
}

std::string claims_text(std::size_t printed, std::size_t ours) {
  if (printed == 0 && ours > 0) return counted(ours, "claim") + " of our own";
  return counted(printed, "claim") + " as printed" + (ours == 0 ? "" : fmt::format(", {} of our own", ours));
}

std::string counts_text(const CountsByOrigin& counts) {
  const std::string printed = sentence_of(counts.printed, "", "judged as printed");
  const std::string ours = sentence_of(counts.ours, " of our own", "judged");
  return printed + (printed.empty() || ours.empty() ? "" : " ") + ours;
}

}  // namespace slipproof
