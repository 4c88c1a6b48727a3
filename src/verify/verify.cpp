#include "verify/verify.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <mutex>
#include <span>
#include <tuple>
#include <utility>

#include "parallel/in_parallel.hpp"
#include "verify/claim_lines.hpp"
#include "verify/counterexample.hpp"
#include "verify/identity.hpp"
#include "verify/simplify.hpp"
#include "verify/vacuous.hpp"

namespace slipproof {

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 4> names{"holds", "refuted", "undecided", "vacuous"};
  return names[static_cast<std::size_t>(verdict)];
}

namespace {

/// Lines of a claim are laid through the first so many samples at which it held.
constexpr std::size_t max_bases = 64;

/// The least numbers of all that were added, in whatever order.
class FirstSamples {
 public:
  void add(std::uint64_t i) {
    if (numbers_.size() < max_bases || i < numbers_.back()) add({&i, 1});
  }
  void add(std::span<const std::uint64_t> others) {
    numbers_.insert(numbers_.end(), others.begin(), others.end());
    std::sort(numbers_.begin(), numbers_.end());
    if (numbers_.size() > max_bases) numbers_.resize(max_bases);
  }
  bool full() const { return numbers_.size() == max_bases; }
  const std::vector<std::uint64_t>& numbers() const { return numbers_; }

 private:
  std::vector<std::uint64_t> numbers_;
};

/// The simplest of some samples.
struct Simplest {
  std::vector<Rational> values;  ///< empty: there is none yet
  Complexity its_complexity;

  void keep(const std::vector<Rational>& other, const Complexity& c) {
    if (!values.empty() && !(std::tie(c, other) < std::tie(its_complexity, values))) return;
    values = other;
    its_complexity = c;
  }
  void keep(const Simplest& other) {
    if (!other.values.empty()) keep(other.values, other.its_complexity);
  }
};

/// What one claim in one reading comes to over some samples; sums do not depend on their order.
struct Tally {
  std::uint64_t tried = 0, held = 0, refuted = 0, undecided = 0;
  std::uint64_t lines = 0, cells = 0;
  FirstSamples held_at, speaks_at;  ///< samples at which it held; those of them at which there is a force for it
  Simplest simplest, realisable;    ///< of the failing samples, and of those of them that can be built

  void add(Outcome outcome, const CompiledSetting& setting, const std::vector<Rational>& values) {
    ++tried;
    if (outcome == Outcome::holds) ++held;
    if (outcome == Outcome::undecided) ++undecided;
    if (outcome != Outcome::refuted) return;
    ++refuted;
    const Complexity c = complexity(values);
    simplest.keep(values, c);
    if (unrealisable(setting, values).empty()) realisable.keep(values, c);
  }
  void add(const Tally& other) {
    tried += other.tried;
    lines += other.lines;
    cells += other.cells;
    held_at.add(other.held_at.numbers());
    speaks_at.add(other.speaks_at.numbers());
    held += other.held;
    refuted += other.refuted;
    undecided += other.undecided;
    simplest.keep(other.simplest);
    realisable.keep(other.realisable);
  }
};

struct Task {
  std::size_t claim;
  Reading reading;
  std::optional<Identity> identity;
  /// True or false of rational functions: where it is false, it is so nearly everywhere.
  bool rational = false;
};

/// A claim whose lines are to be judged, and what that needs.
struct LineTask {
  std::size_t task;
  ClaimLines lines;
  std::vector<std::vector<Rational>> bases;  ///< bicycles that the lines go through
};

std::vector<Task> tasks_of(const ClaimsFile& file, const CompiledClaims& compiled, const std::string& only,
                           LemmaBook& book) {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < file.claims.size(); ++i) {
    const Claim& claim = file.claims[i];
    if (!claim.id.starts_with(only)) continue;
    for (const Reading reading : all_readings) {
      if (reading == Reading::repaired && !claim.repaired) continue;
      Task task{i, reading, find_identity(file, compiled, i, reading, &book)};
      task.rational = task.identity || claim.is<Consequence>() || claim.is<System>();
      tasks.push_back(std::move(task));
    }
  }
  return tasks;
}

class Run {
 public:
  Run(const ClaimsFile& file, const VerifyOptions& options)
      : file_(file),
        compiled_(file),
        options_(options),
        lines_(options.line_count()),
        tasks_(tasks_of(file, compiled_, options.only, book_)),
        tallies_(tasks_.size()),
        total_(options.samples * file.settings.size() + lines_ * tasks_.size()) {}

  VerifyResult result() {
    VerifyResult result{options_.samples, lines_, options_.seed, std::vector<ClaimResult>(tasks_.size())};
    on_threads(options_.threads, [&] {
      for (std::size_t s = 0; s < file_.settings.size(); ++s) sample(s);
      judge_lines();
      in_parallel(0, tasks_.size(), [&](std::size_t t) { result.claims[t] = conclude(t); });
    });
    return result;
  }

 private:
  void sample(std::size_t setting) {
    const auto here = [&](const Task& task) { return file_.claims[task.claim].setting == setting; };
    if (std::none_of(tasks_.begin(), tasks_.end(), here)) return;
    const Sampler sampler(compiled_.settings[setting], options_.seed);
    pieces_in_parallel(0, options_.samples, 64, [&](std::size_t begin, std::size_t end) {
      std::vector<Tally> tallies(tasks_.size());
      for (std::uint64_t i = begin; i != end; ++i) {
        stop_if_asked();
        judge_sample(setting, i, sampler.at(i), tallies);
      }
      const std::scoped_lock lock(mutex_);
      for (std::size_t t = 0; t < tasks_.size(); ++t) tallies_[t].add(tallies[t]);
      tell(end - begin);
    });
  }

  void tell(std::uint64_t done) {
    done_ += done;
    if (options_.progress) options_.progress(done_, total_);
  }

  /// What samples refute needs no lines. Identities do: they may lack a value where something vanishes.
  bool wants_lines(std::size_t t) const {
    const Claim& claim = file_.claims[tasks_[t].claim];
    const bool linear = claim.is<Consequence>() || claim.is<System>();
    return !linear && tallies_[t].refuted == 0 && (!claim.is<Exists>() || tallies_[t].held == 0);
  }

  /// The first bicycles among the samples of a setting.
  std::vector<std::vector<Rational>> first_bicycles(std::size_t setting) const {
    const Sampler sampler(compiled_.settings[setting], options_.seed);
    std::vector<std::vector<Rational>> found;
    for (std::uint64_t i = 0; i < options_.samples && found.size() < max_bases; ++i) {
      stop_if_asked();
      auto values = sampler.at(i);
      if (!values.empty() && solved(setting, values)) found.push_back(std::move(values));
    }
    return found;
  }

  std::vector<LineTask> line_tasks(std::size_t setting) const {
    const CompiledSetting& compiled = compiled_.settings[setting];
    const Sampler sampler(compiled, options_.seed);
    std::vector<LineTask> result;
    std::vector<std::vector<Rational>> anywhere;
    for (std::size_t t = 0; t < tasks_.size(); ++t) {
      if (file_.claims[tasks_[t].claim].setting != setting || !wants_lines(t)) continue;
      auto lines = claim_lines(file_, compiled_, tasks_[t].claim, tasks_[t].reading);
      if (!lines) continue;
      LineTask task{t, std::move(*lines), {}};
      const FirstSamples& first = tallies_[t].speaks_at.numbers().empty() ? tallies_[t].held_at : tallies_[t].speaks_at;
      for (const std::uint64_t i : first.numbers()) task.bases.push_back(sampler.at(i));
      if (task.bases.empty()) {
        if (anywhere.empty()) anywhere = first_bicycles(setting);
        task.bases = anywhere;
      }
      if (!task.bases.empty()) result.push_back(std::move(task));
    }
    return result;
  }

  std::size_t setting_of(const Task& task) const { return file_.claims[task.claim].setting; }

  void judge_lines() {
    if (lines_ == 0) return;
    std::vector<LineTask> tasks;
    for (std::size_t s = 0; s < file_.settings.size(); ++s) std::ranges::move(line_tasks(s), std::back_inserter(tasks));
    std::vector<std::pair<const LineTask*, std::uint64_t>> lines;
    for (const LineTask& task : tasks) {
      for (std::uint64_t number = 0; number < lines_for(task); ++number) lines.emplace_back(&task, number);
    }
    total_ = done_ + lines.size();  // exact from here on
    in_parallel(0, lines.size(), [&](std::size_t i) {
      const auto& [task, number] = lines[i];
      const Tally tally = judge_line(*task, number);
      const std::scoped_lock lock(mutex_);
      tallies_[task->task].add(tally);
      tell(1);
    });
  }

  /// Where no sample was in a claim's region, each parameter that matters runs three times at least: on some line the
  /// region begins and ends.
  std::uint64_t lines_for(const LineTask& task) const {
    if (!tallies_[task.task].held_at.numbers().empty()) return lines_;
    const auto matter = std::count(task.lines.matters.begin(), task.lines.matters.end(), true);
    return std::max(lines_, 9 * static_cast<std::uint64_t>(matter));
  }

  Tally judge_line(const LineTask& line_task, std::uint64_t number) const {
    const Task& task = tasks_[line_task.task];
    const std::size_t setting = setting_of(task);
    const CompiledSetting& compiled = compiled_.settings[setting];
    const Line line = line_number(number, options_.seed + line_task.task, line_task.bases, line_task.lines.matters);
    Tally tally;
    tally.lines = 1;
    tally.cells = visit_line(line, compiled, line_task.lines.parts, [&](SolvedSample& sample) {
      tally.add(judge(file_, compiled_, task.claim, task.reading, sample).outcome, compiled, sample.values());
      return true;
    });
    return tally;
  }

  std::unique_ptr<SolvedSample> solved(std::size_t setting, std::vector<Rational> values) const {
    return SolvedSample::make(compiled_.settings[setting], std::move(values));
  }

  void judge_sample(std::size_t setting, std::uint64_t i, std::vector<Rational> values,
                    std::vector<Tally>& tallies) const {
    if (values.empty()) return;
    const auto sample = solved(setting, std::move(values));
    if (!sample) return;
    for (std::size_t t = 0; t < tasks_.size(); ++t) {
      if (file_.claims[tasks_[t].claim].setting != setting) continue;
      if (tasks_[t].rational && i % thinned_to != 0) continue;
      const Judgement j = judge(file_, compiled_, tasks_[t].claim, tasks_[t].reading, *sample);
      tallies[t].add(j.outcome, compiled_.settings[setting], sample->values());
      if (j.outcome == Outcome::holds && lines_ > 0) remember(i, tasks_[t], *sample, tallies[t]);
    }
  }

  /// A line through a bicycle at which the claim says something of some force is worth more than one through any other.
  void remember(std::uint64_t i, const Task& task, SolvedSample& sample, Tally& tally) const {
    tally.held_at.add(i);
    if (tally.speaks_at.full()) return;
    const auto forces = sample.true_at(compiled_.claims[task.claim].body(task.reading).forces);
    if (!forces.parts.empty()) tally.speaks_at.add(i);
  }

  ClaimResult conclude(std::size_t t) {
    const Tally& tally = tallies_[t];
    const Task& task = tasks_[t];
    ClaimResult result;
    result.claim = tasks_[t].claim;
    result.reading = tasks_[t].reading;
    result.tried = tally.tried;
    result.held = tally.held;
    result.refuted = tally.refuted;
    result.undecided = tally.undecided;
    result.lines = tally.lines;
    result.cells = tally.cells;
    if (task.identity) result.unless_zero = task.identity->unless_zero;
    if (tally.refuted > 0) {
      result.verdict = Verdict::refuted;
      auto found =
          counterexamples(file_, compiled_, task.claim, task.reading, {tally.simplest.values, tally.realisable.values},
                          options_.simplify ? Showing::simplest : Showing::as_found, options_.seed);
      result.counterexample = std::move(found.shown);
      result.simplest = std::move(found.simpler);
    } else if (file_.claims[task.claim].is<Exists>()) {
      result.verdict = tally.held > 0 ? Verdict::holds : Verdict::undecided;
      result.proved = tally.held > 0;
      if (tally.held == 0 && is_nowhere(file_, task.claim, task.reading, book_)) result.verdict = Verdict::refuted;
    } else if (tally.undecided == 0 && tally.held > 0) {
      result.verdict = Verdict::holds;
      result.proved = task.identity && task.identity->proved();
    } else if (tally.undecided == 0 && is_vacuous(file_, task.claim, task.reading, book_)) {
      result.verdict = Verdict::vacuous;
    }
    return result;
  }

  const ClaimsFile& file_;
  const CompiledClaims compiled_;
  const VerifyOptions& options_;
  const std::uint64_t lines_;
  LemmaBook book_{
      {.split_depth = 1, .slack_attempts = 100, .products = 0, .quick_samples = 0, .samples = 0, .steps = 2'000'000}};
  const std::vector<Task> tasks_;
  std::vector<Tally> tallies_;
  std::uint64_t done_ = 0, total_;
  std::mutex mutex_;
};

}  // namespace

const ClaimResult* VerifyResult::find(const ClaimsFile& file, std::string_view id, Reading reading) const {
  for (const ClaimResult& result : claims) {
    if (file.claims[result.claim].id == id && result.reading == reading) return &result;
  }
  return nullptr;
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

VerifyResult verify(const ClaimsFile& file, const VerifyOptions& options) {
  VerifyResult result = Run(file, options).result();
  if (!options.certificates) return result;
  find_certificates(file, result, *options.certificates);
  result.second_checker = options.certificates->second_checker();
  return result;
}

}  // namespace slipproof
