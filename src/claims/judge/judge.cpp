#include "claims/judge/judge.hpp"

#include <vector>

#include "claims/judge/claim_judge.hpp"

namespace slipproof {

Judgement ClaimJudge::judge() {
  Judgement j = judged();
  if (j.outcome == Outcome::undecided && is_unsure()) j.reason = Reason::unsure;
  return j;
}

bool ClaimJudge::is_unsure() {
  bool unsure = false;
  std::vector<const Program*> all{&compiled().force_domain()};
  if (sample_.force_domain()) all.insert(all.end(), {&programs_.forces, &programs_.holds});
  for (const Program* program : all) {
    for (const TruthCell& cell : sample_.over_forces(*program)) {
      if (sample_.force_domain() && common(cell.forces, domain()).empty()) continue;
      if (cell.truth == Truth::undefined) return false;
      unsure = unsure || cell.truth == Truth::undecided;
    }
  }
  if (!sample_.force_domain()) return unsure;      // whatever the claim says, it has no value
  for (const std::size_t other : body().claims) {  // their ends may be irrational
    for (const TruthCell& cell : sample_.over_forces(programs(other).forces)) {
      unsure = unsure || cell.truth == Truth::undecided;
    }
  }
  return unsure;
}

Judgement ClaimJudge::judged() {
  if (!sample_.force_domain()) return undecided();
  if (body().parameter.empty()) {  // for a limit, the region at the end of the parameter's domain counts
    const Truth inside = sample_.region(programs_.region);
    if (no_value(inside)) return undecided();
    if (inside == Truth::no) return {};
  }
  return body().kind->judge(*this);
}

Judgement judge(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
                SolvedSample& sample) {
  return ClaimJudge(file, compiled, claim, reading, sample).judge();
}

}  // namespace slipproof
