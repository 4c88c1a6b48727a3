#include "claims/mutation/baselines.hpp"

#include "base/parallel/failure.hpp"
#include "base/parallel/in_parallel.hpp"
#include "claims/sampling/edges.hpp"
#include "claims/sampling/reach.hpp"
#include "claims/sampling/sampler.hpp"

namespace slipproof {

void Baselines::solve(std::size_t s, std::uint64_t count, const std::vector<std::size_t>& claims) {
  Samples& samples = samples_[s];
  const std::size_t first = samples.size();
  if (count <= first) return;
  samples.resize(count);
  for (std::size_t c = 0; c < file_.claims.size(); ++c) {
    if (file_.claims[c].setting == s) baselines_[c].resize(count);
  }
  const Sampler sampler(compiled_.settings[s], options_.seed);
  in_parallel(first, count, [&](std::size_t i) {
    std::vector<Rational> values = sampler.at(i);
    if (values.empty()) return;
    // A mutant that survived has passed the samples that the sampler is best at.
    if (i >= options_.samples && i % 2 == 1) {
      values = toward_edges(file_.settings[s], compiled_.settings[s], values, i);
    }
    auto sample = SolvedSample::make(compiled_.settings[s], std::move(values));
    if (!sample) return;
    for (const std::size_t c : claims) {
      if (file_.claims[c].setting != s) continue;
      Baseline& baseline = baselines_[c][i];
      const std::string failure = failure_of([&] { baseline = baseline_of(c, *sample); });
      if (!failure.empty()) baseline.outcome = Outcome::undecided;
    }
    // Solves the sample before threads share it.
    if (failure_of([&] { sample->motions(); }).empty()) samples[i] = std::move(sample);
  });
}

Baseline Baselines::baseline_of(std::size_t c, SolvedSample& sample) const {
  Baseline result;
  result.outcome = judge(file_, compiled_, c, Reading::printed, sample).outcome;
  result.reach = reach(file_, compiled_, c, sample);
  result.speaks = result.outcome == Outcome::holds && !sample.true_at(compiled_.claims[c].printed.forces).parts.empty();
  return result;
}

std::vector<std::size_t> Baselines::samples_from(std::size_t setting, std::size_t first) const {
  std::vector<std::size_t> order;
  for (std::size_t i = first; i < samples_[setting].size(); ++i) {
    if (samples_[setting][i]) order.push_back(i);
  }
  return order;
}

std::vector<std::vector<Rational>> Baselines::speaks_at(std::size_t c) const {
  constexpr std::size_t enough = 64;
  std::vector<std::vector<Rational>> speaks, holds;
  const Samples& samples = samples_[file_.claims[c].setting];
  for (std::size_t i = 0; i < samples.size() && speaks.size() < enough; ++i) {
    const Baseline& here = baselines_[c][i];
    if (here.outcome == Outcome::holds) (here.speaks ? speaks : holds).push_back(samples[i]->values());
  }
  return speaks.empty() ? holds : speaks;
}

}  // namespace slipproof
