#include "claims/verify/task_samples.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel/failure.hpp"
#include "base/parallel/in_parallel.hpp"
#include "claims/lines/claim_lines.hpp"
#include "claims/sampling/sampler.hpp"

namespace slipproof {

namespace {

/// The number of samples of a setting in one request. The work of rank 0 for a result hardly grows with it.
std::uint64_t samples_a_piece(std::uint64_t samples) {
  constexpr std::uint64_t least = 32, most_pieces = 16'384;
  return std::max(least, (samples + most_pieces - 1) / most_pieces);
}

/// Remembers a bicycle for lines: one at which the claim says something about a force is better than any other.
void remember(const PaperTasks& tasks, const ClaimTask& task, std::uint64_t i, SolvedSample& sample, Tally& tally) {
  tally.held_at.add(i);
  if (tally.speaks_at.full()) return;
  const auto forces = sample.true_at(tasks.compiled.claims[task.claim].body(task.reading).forces);
  if (!forces.parts.empty()) tally.speaks_at.add(i);
}

void judge_claim(const PaperTasks& tasks, const ClaimTask& task, std::uint64_t i, SolvedSample& sample, Tally& tally) {
  const Judgement j = judge(tasks.file, tasks.compiled, task.claim, task.reading, sample);
  tally.add(j, tasks.setting_of(task), sample.values());
  if (j.outcome == Outcome::holds && tasks.options.line_count() > 0) remember(tasks, task, i, sample, tally);
}

void judge_sample(const PaperTasks& tasks, std::size_t setting, std::uint64_t i, const Sampler& sampler,
                  std::vector<Tally>& tallies) {
  std::unique_ptr<SolvedSample> sample;
  const std::string unsolved = failure_of([&] {
    std::vector<Rational> values = sampler.at(i);
    if (!values.empty()) sample = SolvedSample::make(tasks.compiled.settings[setting], std::move(values));
  });
  if (!sample && unsolved.empty()) return;
  for (std::size_t t = 0; t < tasks.all.size(); ++t) {
    const ClaimTask& task = tasks.all[t];
    if (tasks.claim_of(task).setting != setting) continue;
    if (task.rational && i % thinned_to != 0) continue;
    tallies[t].fail(!sample ? unsolved : failure_of([&] { judge_claim(tasks, task, i, *sample, tallies[t]); }));
  }
}

/// Values of all parameters of a setting; nothing if a name is missing, or if an angle has no half tangent.
std::optional<std::vector<Rational>> values_of(const Setting& setting, const NamedValues& numbers) {
  const auto number = [&](const std::string& name) -> const Rational* {
    const auto found = std::find_if(numbers.begin(), numbers.end(), [&](const auto& one) { return one.first == name; });
    return found == numbers.end() ? nullptr : &found->second;
  };
  std::vector<Rational> values;
  for (const FreeParameter& parameter : setting.parameters) {
    if (!parameter.angle) {
      const Rational* value = number(parameter.symbol);
      if (value == nullptr) return std::nullopt;
      values.push_back(*value);
      continue;
    }
    const FreeAngle& angle = setting.angles[*parameter.angle];
    const Rational *cosine = number(angle.cosine), *sine = number(angle.sine);
    if (cosine == nullptr || sine == nullptr || *cosine == -1) return std::nullopt;
    values.push_back(*sine / (1 + *cosine));
  }
  return values;
}

}  // namespace

void judge_at(const PaperTasks& tasks, const ClaimTask& task, const NamedValues& numbers, Tally& tally) {
  const CompiledSetting& setting = tasks.setting_of(task);
  auto values = values_of(tasks.file.settings[tasks.claim_of(task).setting], numbers);
  if (!values) return;
  const auto sample = SolvedSample::in_domain(setting, *std::move(values));
  if (!sample) return;
  const Judgement j = judge(tasks.file, tasks.compiled, task.claim, task.reading, *sample);
  tally.add(j, setting, sample->values());
}

std::vector<SamplePiece> sample_pieces(const PaperTasks& tasks) {
  const std::uint64_t samples = tasks.options.samples, size = samples_a_piece(samples);
  std::vector<SamplePiece> pieces;
  for (std::size_t s = 0; s < tasks.file.settings.size(); ++s) {
    const auto here = [&](const ClaimTask& task) { return tasks.claim_of(task).setting == s; };
    if (std::none_of(tasks.all.begin(), tasks.all.end(), here)) continue;
    for (std::uint64_t begin = 0; begin < samples; begin += size) {
      pieces.push_back({s, begin, std::min(begin + size, samples)});
    }
  }
  return pieces;
}

std::string judge_samples(const PaperTasks& tasks, const SamplePiece& piece) {
  const Sampler sampler(tasks.compiled.settings.at(piece.setting), tasks.options.seed);
  std::vector<Tally> tallies(tasks.all.size());
  for (std::uint64_t i = piece.begin; i != piece.end; ++i) {
    stop_if_asked();
    judge_sample(tasks, piece.setting, i, sampler, tallies);
  }
  const auto spoken = std::count_if(tallies.begin(), tallies.end(), [](const Tally& tally) { return !tally.empty(); });
  ByteWriter bytes;
  bytes.number(static_cast<std::uint64_t>(spoken));
  for (std::size_t t = 0; t < tallies.size(); ++t) {
    if (tallies[t].empty()) continue;
    bytes.number(t);
    write_tally(bytes, tallies[t]);
  }
  return bytes.take();
}

void add_tallies(std::string_view judged, std::vector<Tally>& tallies) {
  ByteReader bytes(judged);
  for (std::uint64_t left = bytes.number(); left > 0; --left) {
    const std::size_t t = bytes.number();
    tallies.at(t).add(read_tally(bytes));
  }
}

Tally judge_line(const PaperTasks& tasks, const ClaimTask& task, const Line& line) {
  const CompiledSetting& setting = tasks.setting_of(task);
  Tally tally;
  tally.lines = 1;
  tally.fail(failure_of([&] {
    const ClaimParts parts = parts_of(tasks.file, tasks.compiled, task.claim, task.reading);
    tally.cells = visit_line(line, setting, parts, [&](SolvedSample& sample) {
      tally.add(judge(tasks.file, tasks.compiled, task.claim, task.reading, sample), setting, sample.values());
      return true;
    });
  }));
  return tally;
}

}  // namespace slipproof
