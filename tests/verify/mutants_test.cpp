// The verifier notices: mutants of the Assertions' definitions, regions and bounds are refuted.
#include <doctest/doctest.h>

#include <algorithm>

#include "claims/claims_mutants.hpp"
#include "verify/judge.hpp"
#include "verify/sampler.hpp"
#include "verify/shipped.hpp"

using namespace slipproof;

namespace {

using Samples = std::vector<std::unique_ptr<SolvedSample>>;

Samples solved_samples(const ClaimsFile& file, const CompiledClaims& compiled, std::uint64_t seed,
                       std::uint64_t count) {
  const std::size_t s = test::section_3(file);
  const Sampler sampler(compiled.settings[s], seed);
  Samples samples;
  for (std::uint64_t i = 0; i < count; ++i) {
    samples.push_back(SolvedSample::make(compiled.settings[s], file.settings[s].force_kind, sampler.at(i)));
    REQUIRE(samples.back());
  }
  return samples;
}

bool states_forces(const Claim& claim) {
  return claim.id.starts_with("A") &&
         (claim.kind == ClaimKind::interval || claim.kind == ClaimKind::impossible || claim.kind == ClaimKind::motions);
}

/// What a claim says at a sample: nothing, or where in the domain of the force it says what.
std::vector<std::pair<ForceInterval, Truth>> said(const CompiledBody& body, SolvedSample& sample) {
  std::vector<std::pair<ForceInterval, Truth>> result;
  if (sample.region(body.region) != Truth::yes) return result;
  for (const TruthCell& cell : sample.over_forces(body.forces)) {
    ForceInterval forces = cell.forces;
    forces.intersect(*sample.force_domain());
    if (!forces.empty()) result.emplace_back(forces, cell.truth);
  }
  return result;
}

}  // namespace

TEST_CASE("every mutant of the Assertions that changes a claimed set is caught") {
  const ClaimsFile file = as_read(test::shipped_paper(), Reading::repaired);
  const CompiledClaims compiled(file);
  const std::size_t setting = test::section_3(file);
  Samples samples = solved_samples(file, compiled, 1, 300), others = solved_samples(file, compiled, 77, 150);
  std::vector<bool> as_it_is(file.claims.size());  // A2.cover leaves out b = b1 unmutated
  for (std::size_t i = 0; i < file.claims.size(); ++i) {
    as_it_is[i] =
        file.claims[i].setting == setting && std::none_of(samples.begin(), samples.end(), [&](const auto& sample) {
          return judge(file, compiled, i, Reading::printed, *sample).outcome == Outcome::refuted;
        });
  }
  int caught = 0, narrower = 0, unchanged = 0, index = 0;
  std::vector<std::string> survivors;
  for (const ClaimsMutant& mutant : mutants(file)) {
    std::vector<std::size_t> claims = mutant.claims;
    std::erase_if(claims, [&](std::size_t i) { return !states_forces(file.claims[i]); });
    std::vector<std::size_t> judges = mutant.claims;  // with A5.2 and the claims of covering, that see what is left out
    std::erase_if(judges, [&](std::size_t i) { return file.claims[i].kind == ClaimKind::formula || !as_it_is[i]; });
    if (claims.empty() || mutant.part == ClaimsMutant::Part::holds || index++ % 8 != 0) continue;
    const ClaimsFile changed = mutant.apply(file);
    const CompiledClaims recompiled(changed);
    const auto refuted = [&](const std::unique_ptr<SolvedSample>& sample) {
      const auto mutated = sample->under(recompiled.settings[setting]);
      return std::any_of(judges.begin(), judges.end(), [&](std::size_t i) {
        const Outcome outcome = judge(changed, recompiled, i, Reading::printed, *mutated).outcome;
        return outcome == Outcome::refuted || outcome == Outcome::undecided;
      });
    };
    if (std::any_of(samples.begin(), samples.end(), refuted)) {
      ++caught;
      continue;
    }
    // Not caught. A claim that only speaks of fewer bicycles is as true as before (claims of covering notice those);
    // where it speaks, it must say the same.
    bool less = false, differs = false;
    for (const auto& sample : others) {
      const auto mutated = sample->under(recompiled.settings[setting]);
      for (const std::size_t i : claims) {
        const auto before = said(compiled.claims[i].printed, *sample),
                   after = said(recompiled.claims[i].printed, *mutated);
        less = less || (after.empty() && !before.empty());
        differs = differs || (!after.empty() && !before.empty() && before != after);
      }
    }
    if (differs) {
      survivors.push_back(mutant.where + ": " + mutant.mutant.description);
    } else {
      ++(less ? narrower : unchanged);
    }
  }
  MESSAGE(caught << " mutants caught; " << narrower << " speak of fewer bicycles, " << unchanged
                 << " say the same; survivors: " << survivors.size());
  for (const std::string& survivor : survivors) MESSAGE(survivor);
  CHECK(caught >= 200);
  CHECK(survivors.empty());
}
