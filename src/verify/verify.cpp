#include "verify/verify.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "parallel/in_parallel.hpp"
#include "scatter/share.hpp"
#include "verify/claim_lines.hpp"
#include "verify/counterexample.hpp"
#include "verify/identity.hpp"
#include "verify/tally.hpp"
#include "verify/vacuous.hpp"

namespace slipproof {

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 4> names{"holds", "refuted", "undecided", "vacuous"};
  return names[static_cast<std::size_t>(verdict)];
}

namespace {

/// What a rank is asked about a paper.
enum class VerifyQuestion : std::uint64_t { samples, line, conclusion, certificates };

/// A request is about so many samples of a setting: what rank 0 does for a result hardly grows with them.
std::uint64_t samples_a_piece(std::uint64_t samples) {
  constexpr std::uint64_t least = 32, most_pieces = 16'384;
  return std::max(least, (samples + most_pieces - 1) / most_pieces);
}

/// What becomes of a claim, apart from what is quickly seen.
struct Conclusion {
  bool vacuous = false;  ///< or nowhere, of a claim of existence
  std::optional<SimplestFailures> failures;
};

void write_simplified(ByteWriter& bytes, const std::optional<Simplified>& found) {
  bytes.number(found && found->minimal ? 1 : 0).rationals(found ? found->values : std::vector<Rational>{});
}

std::optional<Simplified> read_simplified(ByteReader& bytes) {
  const bool minimal = bytes.number() != 0;
  std::vector<Rational> values = bytes.rationals();
  return values.empty() ? std::nullopt : std::optional(Simplified{std::move(values), minimal});
}

std::string conclusion_bytes(const Conclusion& conclusion) {
  ByteWriter bytes;
  bytes.number(conclusion.vacuous ? 1 : 0);
  write_simplified(bytes, conclusion.failures ? std::optional(conclusion.failures->shown) : std::nullopt);
  write_simplified(bytes, conclusion.failures ? conclusion.failures->simpler : std::nullopt);
  return bytes.take();
}

Conclusion read_conclusion(std::string_view text) {
  ByteReader bytes(text);
  Conclusion conclusion{.vacuous = bytes.number() != 0, .failures = {}};
  std::optional<Simplified> shown = read_simplified(bytes), simpler = read_simplified(bytes);
  if (shown) conclusion.failures.emplace(*std::move(shown), std::move(simpler));
  bytes.end();
  return conclusion;
}

}  // namespace

class Verification::Run {
 public:
  Run(const ClaimsFile& file, const VerifyOptions& options, std::uint64_t paper)
      : file_(file),
        compiled_(file),
        options_(options),
        paper_(paper),
        lines_(options.line_count()),
        tasks_(tasks_of(file, compiled_, options.only, book_)),
        tallies_(tasks_.size()),
        total_(options.samples * file.settings.size() + lines_ * tasks_.size()) {}

  VerifyResult result(Crew* crew) {
    VerifyResult result{options_.samples, lines_, options_.seed, std::vector<ClaimResult>(tasks_.size())};
    on_threads(options_.threads, [&] {
      if (options_.certificates) check_certificates(crew);
      sample(crew);
      judge_lines(crew);
      const std::vector<std::string> conclusions = conclude(crew);
      in_parallel(0, tasks_.size(),
                  [&](std::size_t t) { result.claims[t] = concluded(t, read_conclusion(conclusions[t])); });
    });
    if (!options_.certificates) return result;
    find_certificates(file_, result, *options_.certificates);
    result.second_checker = options_.certificates->second_checker();
    return result;
  }

  std::string answer(std::string_view request) {
    ByteReader bytes(request);
    bytes.number();  // the paper
    const auto question = static_cast<VerifyQuestion>(bytes.number());
    const std::size_t which = bytes.number();
    if (question == VerifyQuestion::samples) {
      const std::uint64_t begin = bytes.number();
      return judge_samples({which, begin, bytes.number()});
    }
    if (question == VerifyQuestion::line) {
      Line line{bytes.rationals(), bytes.rationals(), bytes.rationals().at(0)};
      ByteWriter tally;
      write_tally(tally, judge_line(which, line));
      return tally.take();
    }
    if (question == VerifyQuestion::certificates) {
      const Task& task = tasks_.at(which);
      return slipproof::check_certificates(file_, task.claim, task.reading, options_.certificates->folder());
    }
    return conclusion_bytes(conclusion(which, read_tally(bytes)));
  }

 private:
  struct SamplePiece {
    std::size_t setting;
    std::uint64_t begin, end;
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
    std::vector<bool> matters;                 ///< by parameter
    std::vector<std::vector<Rational>> bases;  ///< bicycles that the lines go through
  };

  static std::vector<Task> tasks_of(const ClaimsFile& file, const CompiledClaims& compiled, const std::string& only,
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

  ByteWriter about(VerifyQuestion question, std::uint64_t which) const {
    ByteWriter request;
    request.number(paper_).number(static_cast<std::uint64_t>(question)).number(which);
    return request;
  }
  Service service() {
    return [this](std::string_view request) { return answer(request); };
  }

  std::vector<SamplePiece> pieces() const {
    std::vector<SamplePiece> result;
    for (std::size_t s = 0; s < file_.settings.size(); ++s) {
      const auto here = [&](const Task& task) { return setting_of(task) == s; };
      if (std::none_of(tasks_.begin(), tasks_.end(), here)) continue;
      const std::uint64_t size = samples_a_piece(options_.samples);
      for (std::uint64_t begin = 0; begin < options_.samples; begin += size) {
        result.push_back({s, begin, std::min(begin + size, options_.samples)});
      }
    }
    return result;
  }

  /// A request names what stands in the folder: a run that goes on may find other certificates there.
  void check_certificates(Crew* crew) {
    const std::string digest = crew != nullptr ? options_.certificates->digest() : std::string();
    share(
        crew, service(), tasks_.size(),
        [&](std::uint64_t t) { return about(VerifyQuestion::certificates, t).text(digest).take(); },
        [&](std::uint64_t, const std::string& checked) { options_.certificates->take(checked); });
  }

  void sample(Crew* crew) {
    const std::vector<SamplePiece> all = pieces();
    const auto request = [&](std::uint64_t i) {
      return about(VerifyQuestion::samples, all[i].setting).number(all[i].begin).number(all[i].end).take();
    };
    share(crew, service(), all.size(), request, [&](std::uint64_t i, const std::string& result) {
      ByteReader bytes(result);
      for (std::uint64_t left = bytes.number(); left > 0; --left) {
        const std::size_t t = bytes.number();
        tallies_.at(t).add(read_tally(bytes));
      }
      tell(all[i].end - all[i].begin);
    });
  }

  /// The tallies of the claims that say something of the samples.
  std::string judge_samples(const SamplePiece& piece) const {
    const Sampler sampler(compiled_.settings.at(piece.setting), options_.seed);
    std::vector<Tally> tallies(tasks_.size());
    for (std::uint64_t i = piece.begin; i != piece.end; ++i) {
      stop_if_asked();
      judge_sample(piece.setting, i, sampler.at(i), tallies);
    }
    ByteWriter bytes;
    const auto spoken =
        std::count_if(tallies.begin(), tallies.end(), [](const Tally& tally) { return !tally.empty(); });
    bytes.number(static_cast<std::uint64_t>(spoken));
    for (std::size_t t = 0; t < tallies.size(); ++t) {
      if (tallies[t].empty()) continue;
      bytes.number(t);
      write_tally(bytes, tallies[t]);
    }
    return bytes.take();
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
      LineTask task{t, std::move(lines->matters), {}};
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

  void judge_lines(Crew* crew) {
    if (lines_ == 0) return;
    std::vector<LineTask> tasks;
    for (std::size_t s = 0; s < file_.settings.size(); ++s) std::ranges::move(line_tasks(s), std::back_inserter(tasks));
    std::vector<std::pair<const LineTask*, std::uint64_t>> lines;
    for (const LineTask& task : tasks) {
      for (std::uint64_t number = 0; number < lines_for(task); ++number) lines.emplace_back(&task, number);
    }
    total_ = done_ + lines.size();  // exact from here on
    const auto request = [&](std::uint64_t i) {
      const auto& [task, number] = lines[i];
      const Line line = line_number(number, options_.seed + task->task, task->bases, task->matters);
      ByteWriter bytes = about(VerifyQuestion::line, task->task);
      return bytes.rationals(line.origin).rationals(line.direction).rationals({line.inside}).take();
    };
    share(crew, service(), lines.size(), request, [&](std::uint64_t i, const std::string& result) {
      ByteReader bytes(result);
      tallies_[lines[i].first->task].add(read_tally(bytes));
      tell(1);
    });
  }

  /// Where no sample was in a claim's region, each parameter that matters runs three times at least: on some line the
  /// region begins and ends.
  std::uint64_t lines_for(const LineTask& task) const {
    if (!tallies_[task.task].held_at.numbers().empty()) return lines_;
    const auto matter = std::count(task.matters.begin(), task.matters.end(), true);
    return std::max(lines_, 9 * static_cast<std::uint64_t>(matter));
  }

  Tally judge_line(std::size_t t, const Line& line) const {
    const Task& task = tasks_.at(t);
    const std::size_t setting = setting_of(task);
    const CompiledSetting& compiled = compiled_.settings[setting];
    Tally tally;
    tally.lines = 1;
    const ClaimParts parts = parts_of(file_, compiled_, task.claim, task.reading);
    tally.cells = visit_line(line, compiled, parts, [&](SolvedSample& sample) {
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

  std::vector<std::string> conclude(Crew* crew) {
    std::vector<std::string> conclusions(tasks_.size(), conclusion_bytes({}));
    std::vector<std::size_t> open;
    for (std::size_t t = 0; t < tasks_.size(); ++t) {
      if (!is_concluded(t)) open.push_back(t);
    }
    const auto request = [&](std::uint64_t i) {
      ByteWriter bytes = about(VerifyQuestion::conclusion, open[i]);
      write_tally(bytes, tallies_[open[i]]);
      return bytes.take();
    };
    share(crew, service(), open.size(), request,
          [&](std::uint64_t i, std::string result) { conclusions[open[i]] = std::move(result); });
    return conclusions;
  }

  /// Whether nothing is left to find: what certificates say of existence needs no second proof.
  bool is_concluded(std::size_t t) const {
    const auto& [claim, reading, identity, rational] = tasks_[t];
    if (tallies_[t].refuted > 0) return false;
    if (tallies_[t].held > 0) return true;
    return options_.certificates && file_.claims[claim].is<Exists>() &&
           settled_by_certificates(file_, claim, reading, *options_.certificates);
  }

  Conclusion conclusion(std::size_t t, const Tally& tally) {
    const Task& task = tasks_.at(t);
    if (tally.refuted > 0) {
      return {.failures = simplest_failures(file_, compiled_, task.claim, task.reading,
                                            {tally.simplest.values, tally.realisable.values},
                                            options_.simplify ? Showing::simplest : Showing::as_found, options_.seed)};
    }
    if (file_.claims[task.claim].is<Exists>())
      return {.vacuous = is_nowhere(file_, task.claim, task.reading, book_), .failures = {}};
    return {.vacuous = tally.undecided == 0 && is_vacuous(file_, task.claim, task.reading, book_), .failures = {}};
  }

  ClaimResult concluded(std::size_t t, const Conclusion& conclusion) const {
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
      auto found = counterexamples(file_, compiled_, task.claim, task.reading, conclusion.failures.value());
      result.counterexample = std::move(found.shown);
      result.simplest = std::move(found.simpler);
    } else if (file_.claims[task.claim].is<Exists>()) {
      result.verdict = tally.held > 0 ? Verdict::holds : Verdict::undecided;
      result.proved = tally.held > 0;
      if (conclusion.vacuous) result.verdict = Verdict::refuted;
    } else if (tally.undecided == 0 && tally.held > 0) {
      result.verdict = Verdict::holds;
      result.proved = task.identity && task.identity->proved();
    } else if (conclusion.vacuous) {
      result.verdict = Verdict::vacuous;
    }
    return result;
  }

  const ClaimsFile& file_;
  const CompiledClaims compiled_;
  const VerifyOptions& options_;
  const std::uint64_t paper_;
  const std::uint64_t lines_;
  LemmaBook book_{
      {.split_depth = 1, .slack_attempts = 100, .products = 0, .quick_samples = 0, .samples = 0, .steps = 2'000'000}};
  const std::vector<Task> tasks_;
  std::vector<Tally> tallies_;
  std::uint64_t done_ = 0, total_;
};

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

Verification::Verification(const ClaimsFile& file, const VerifyOptions& options, std::uint64_t paper)
    : run_(std::make_unique<Run>(file, options, paper)) {}

Verification::~Verification() = default;

std::string Verification::answer(std::string_view request) {
  return run_->answer(request);
}

std::uint64_t Verification::paper_of(std::string_view request) {
  return ByteReader(request).number();
}

VerifyResult Verification::result(Crew* crew) {
  return run_->result(crew);
}

VerifyResult verify(const ClaimsFile& file, const VerifyOptions& options) {
  return Verification(file, options).result();
}

}  // namespace slipproof
