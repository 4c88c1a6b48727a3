#include "verify/verify.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <tuple>
#include <utility>

#include "parallel/thread_count.hpp"
#include "verify/identity.hpp"
#include "verify/simplify.hpp"

namespace slipproof {

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 3> names{"holds", "refuted", "undecided"};
  return names[static_cast<std::size_t>(verdict)];
}

namespace {

/// What one claim in one reading comes to over some samples; sums do not depend on their order.
struct Tally {
  std::uint64_t held = 0, refuted = 0, undecided = 0;
  std::vector<Rational> simplest;  ///< of the failing samples
  Complexity its_complexity;

  void add(Outcome outcome, const std::vector<Rational>& values) {
    if (outcome == Outcome::holds) ++held;
    if (outcome == Outcome::undecided) ++undecided;
    if (outcome != Outcome::refuted) return;
    ++refuted;
    keep(values, complexity(values));
  }
  void add(const Tally& other) {
    held += other.held;
    refuted += other.refuted;
    undecided += other.undecided;
    if (!other.simplest.empty()) keep(other.simplest, other.its_complexity);
  }

 private:
  void keep(const std::vector<Rational>& values, const Complexity& c) {
    if (!simplest.empty() && !(std::tie(c, values) < std::tie(its_complexity, simplest))) return;
    simplest = values;
    its_complexity = c;
  }
};

struct Task {
  std::size_t claim;
  Reading reading;
  bool identity = false;  ///< proved as an identity of rational functions
  bool rational = false;  ///< true or false of rational functions: where it is false, it is so nearly everywhere
};

/// What is rational is judged at one sample in so many; prime to the number of the sampler's kinds of samples.
constexpr std::uint64_t thinning = 17;

std::vector<Task> tasks_of(const ClaimsFile& file, const CompiledClaims& compiled, const std::string& only) {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < file.claims.size(); ++i) {
    if (!file.claims[i].id.starts_with(only)) continue;
    const ClaimKind kind = file.claims[i].kind;
    for (const Reading reading : all_readings) {
      if (reading == Reading::repaired && !file.claims[i].repaired) continue;
      const bool identity = is_identity(file, compiled, i, reading);
      const bool rational = identity || kind == ClaimKind::consequence || kind == ClaimKind::system;
      tasks.push_back({i, reading, identity, rational});
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
        tasks_(tasks_of(file, compiled_, options.only)),
        tallies_(tasks_.size()) {}

  VerifyResult result() {
    tbb::task_arena arena(thread_count(options_.threads));
    VerifyResult result{options_.samples, options_.seed, std::vector<ClaimResult>(tasks_.size())};
    arena.execute([&] {
      for (std::size_t s = 0; s < file_.settings.size(); ++s) sample(s);
      tbb::parallel_for(std::size_t{0}, tasks_.size(), [&](std::size_t t) { result.claims[t] = conclude(t); });
    });
    return result;
  }

 private:
  void sample(std::size_t setting) {
    const auto here = [&](const Task& task) { return file_.claims[task.claim].setting == setting; };
    if (std::none_of(tasks_.begin(), tasks_.end(), here)) return;
    const Sampler sampler(compiled_.settings[setting], options_.seed);
    tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, options_.samples, 64), [&](const auto& block) {
      std::vector<Tally> tallies(tasks_.size());
      for (std::uint64_t i = block.begin(); i != block.end(); ++i) judge_sample(setting, i, sampler.at(i), tallies);
      const std::scoped_lock lock(mutex_);
      for (std::size_t t = 0; t < tasks_.size(); ++t) tallies_[t].add(tallies[t]);
      done_ += block.size();
      if (options_.progress) options_.progress(done_, options_.samples * file_.settings.size());
    });
  }

  void judge_sample(std::size_t setting, std::uint64_t i, std::vector<Rational> values,
                    std::vector<Tally>& tallies) const {
    if (values.empty()) return;
    const auto sample =
        SolvedSample::make(compiled_.settings[setting], file_.settings[setting].force_kind, std::move(values));
    if (!sample) return;
    for (std::size_t t = 0; t < tasks_.size(); ++t) {
      if (file_.claims[tasks_[t].claim].setting != setting) continue;
      if (tasks_[t].rational && i % thinning != 0) continue;
      const Judgement j = judge(file_, compiled_, tasks_[t].claim, tasks_[t].reading, *sample);
      tallies[t].add(j.outcome, sample->values());
    }
  }

  ClaimResult conclude(std::size_t t) const {
    const Tally& tally = tallies_[t];
    ClaimResult result;
    result.claim = tasks_[t].claim;
    result.reading = tasks_[t].reading;
    result.held = tally.held;
    result.refuted = tally.refuted;
    result.undecided = tally.undecided;
    if (tally.refuted > 0) {
      result.verdict = Verdict::refuted;
      result.counterexample = counterexample(tasks_[t], tally.simplest);
    } else if (file_.claims[result.claim].kind == ClaimKind::exists) {
      result.verdict = tally.held > 0 ? Verdict::holds : tally.undecided == 0 ? Verdict::refuted : Verdict::undecided;
      result.proved = tally.held > 0;
    } else if (tally.undecided == 0 && tally.held > 0) {
      result.verdict = Verdict::holds;
      result.proved = tasks_[t].identity;
    }
    return result;
  }

  Counterexample counterexample(const Task& task, std::vector<Rational> values) const {
    const std::size_t setting = file_.claims[task.claim].setting;
    const CompiledSetting& compiled = compiled_.settings[setting];
    const ForceKind kind = file_.settings[setting].force_kind;
    const auto judged = [&](const std::vector<Rational>& at) {
      const auto sample = SolvedSample::make(compiled, kind, at);
      return sample ? judge(file_, compiled_, task.claim, task.reading, *sample) : Judgement{};
    };
    bool minimal = false;
    if (options_.simplify) {
      const Judgement original = judged(values);
      const auto fails = [&](const std::vector<Rational>& at) {
        const Judgement j = judged(at);
        return j.outcome == Outcome::refuted && j.reason == original.reason && j.mode == original.mode;
      };
      auto simplified = simplify(compiled, values, fails);
      values = std::move(simplified.values);
      minimal = simplified.minimal;
    }
    auto sample = SolvedSample::make(compiled, kind, values);
    Counterexample example;
    example.judgement = judge(file_, compiled_, task.claim, task.reading, *sample);
    example.scene = sample->scene();
    example.scene.name = "counterexample to " + file_.claims[task.claim].id + ", " + std::string(name(task.reading));
    example.minimal = minimal;
    example.table = std::make_shared<const ModeTable>(example.scene.bicycle, example.scene.road, kind);
    if (const auto& witnesses = example.judgement.witnesses; witnesses && !witnesses->empty()) {
      example.force = witnesses->sample();
      example.scene.F = sample->pedal_force(*example.force);
      example.motions = motions_at(*example.table, *example.scene.F);
    }
    example.values = std::move(values);
    return example;
  }

  const ClaimsFile& file_;
  const CompiledClaims compiled_;
  const VerifyOptions& options_;
  const std::vector<Task> tasks_;
  std::vector<Tally> tallies_;
  std::uint64_t done_ = 0;
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
    case Expectation::none:
    case Expectation::holds:
      break;
  }
  return result.verdict == Verdict::holds;
}

VerifyResult verify(const ClaimsFile& file, const VerifyOptions& options) {
  return Run(file, options).result();
}

}  // namespace slipproof
