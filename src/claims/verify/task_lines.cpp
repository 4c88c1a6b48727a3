#include "claims/verify/task_lines.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel/failure.hpp"
#include "base/parallel/in_parallel.hpp"
#include "claims/lines/claim_lines.hpp"
#include "claims/sampling/sampler.hpp"

namespace slipproof {

namespace {

/// A claim that samples refute needs no lines. An identity does: it may have no value where a divisor vanishes.
bool wants_lines(const Claim& claim, const Tally& tally) {
  return !claim.kind().is_linear() && tally.refuted == 0 && (!claim.kind().traits().seeks || tally.held == 0);
}

/// The first bicycles among the samples of a setting.
std::vector<std::vector<Rational>> first_bicycles(const CompiledSetting& setting, const Sampler& sampler,
                                                  std::uint64_t samples) {
  std::vector<std::vector<Rational>> found;
  for (std::uint64_t i = 0; i < samples && found.size() < max_bases; ++i) {
    stop_if_asked();
    auto values = sampler.at(i);
    if (!values.empty() && SolvedSample::make(setting, values)) found.push_back(std::move(values));
  }
  return found;
}

/// If no sample was in a claim's region, each parameter that matters is varied at least three times: on some line the
/// region begins and ends.
std::uint64_t how_many(std::uint64_t lines, const std::vector<bool>& matters, const Tally& tally) {
  if (!tally.held_at.numbers().empty()) return lines;
  return std::max(lines, 9 * static_cast<std::uint64_t>(std::count(matters.begin(), matters.end(), true)));
}

void add_lines_of_setting(const PaperTasks& tasks, std::size_t setting, std::vector<Tally>& tallies,
                          std::vector<TaskLines>& result) {
  const VerifyOptions& options = tasks.options;
  const Sampler sampler(tasks.compiled.settings[setting], options.seed);
  std::vector<std::vector<Rational>> anywhere;
  for (std::size_t t = 0; t < tasks.all.size(); ++t) {
    const ClaimTask& task = tasks.all[t];
    const Claim& claim = tasks.claim_of(task);
    if (claim.setting != setting || !wants_lines(claim, tallies[t])) continue;
    tallies[t].fail(failure_of([&] {
      auto lines = claim_lines(tasks.file, tasks.compiled, task.claim, task.reading);
      if (!lines) return;
      TaskLines its{t, std::move(lines->matters), {}, 0};
      const FirstSamples& first = tallies[t].speaks_at.numbers().empty() ? tallies[t].held_at : tallies[t].speaks_at;
      for (const std::uint64_t i : first.numbers()) its.bases.push_back(sampler.at(i));
      if (its.bases.empty()) {
        if (anywhere.empty()) anywhere = first_bicycles(tasks.compiled.settings[setting], sampler, options.samples);
        its.bases = anywhere;
      }
      its.count = how_many(options.line_count(), its.matters, tallies[t]);
      if (!its.bases.empty()) result.push_back(std::move(its));
    }));
  }
}

}  // namespace

std::vector<TaskLines> lines_of_tasks(const PaperTasks& tasks, std::vector<Tally>& tallies) {
  std::vector<TaskLines> result;
  if (tasks.options.line_count() == 0) return result;
  for (std::size_t s = 0; s < tasks.file.settings.size(); ++s) add_lines_of_setting(tasks, s, tallies, result);
  return result;
}

}  // namespace slipproof
