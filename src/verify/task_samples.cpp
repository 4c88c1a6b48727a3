#include "verify/task_samples.hpp"

#include <algorithm>
#include <utility>

#include "parallel/in_parallel.hpp"
#include "verify/claim_lines.hpp"
#include "verify/sampler.hpp"

namespace slipproof {

namespace {

/// A request is about so many samples of a setting: what rank 0 does for a result hardly grows with them.
std::uint64_t samples_a_piece(std::uint64_t samples) {
  constexpr std::uint64_t least = 32, most_pieces = 16'384;
  return std::max(least, (samples + most_pieces - 1) / most_pieces);
}

/// A line through a bicycle at which the claim says something of some force is worth more than one through any other.
void remember(const PaperTasks& tasks, const ClaimTask& task, std::uint64_t i, SolvedSample& sample, Tally& tally) {
  tally.held_at.add(i);
  if (tally.speaks_at.full()) return;
  const auto forces = sample.true_at(tasks.compiled.claims[task.claim].body(task.reading).forces);
  if (!forces.parts.empty()) tally.speaks_at.add(i);
}

void judge_sample(const PaperTasks& tasks, std::size_t setting, std::uint64_t i, std::vector<Rational> values,
                  std::vector<Tally>& tallies) {
  if (values.empty()) return;
  const auto sample = SolvedSample::make(tasks.compiled.settings[setting], std::move(values));
  if (!sample) return;
  for (std::size_t t = 0; t < tasks.all.size(); ++t) {
    const ClaimTask& task = tasks.all[t];
    if (tasks.claim_of(task).setting != setting) continue;
    if (task.rational && i % thinned_to != 0) continue;
    const Judgement j = judge(tasks.file, tasks.compiled, task.claim, task.reading, *sample);
    tallies[t].add(j.outcome, tasks.compiled.settings[setting], sample->values());
    if (j.outcome == Outcome::holds && tasks.options.line_count() > 0) remember(tasks, task, i, *sample, tallies[t]);
  }
}

}  // namespace

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
    judge_sample(tasks, piece.setting, i, sampler.at(i), tallies);
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
  const ClaimParts parts = parts_of(tasks.file, tasks.compiled, task.claim, task.reading);
  tally.cells = visit_line(line, setting, parts, [&](SolvedSample& sample) {
    tally.add(judge(tasks.file, tasks.compiled, task.claim, task.reading, sample).outcome, setting, sample.values());
    return true;
  });
  return tally;
}

}  // namespace slipproof
