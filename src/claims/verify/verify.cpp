#include "claims/verify/verify.hpp"

#include <utility>

#include "base/crew/crew.hpp"
#include "base/parallel/failure.hpp"
#include "base/parallel/in_parallel.hpp"
#include "claims/verify/conclusion.hpp"
#include "claims/verify/paper_tasks.hpp"
#include "claims/verify/task_lines.hpp"
#include "claims/verify/task_samples.hpp"

namespace slipproof {

namespace {

/// What a rank can be asked about a paper.
enum class VerifyQuestion : std::uint64_t { samples, line, conclusion, certificates };

}  // namespace

class Verification::Run {
 public:
  Run(const ClaimsFile& file, const VerifyOptions& options, std::uint64_t paper)
      : options_(options),
        paper_(paper),
        tasks_(file, options),
        tallies_(tasks_.all.size()),
        total_(options.samples * file.settings.size() + options.line_count() * tasks_.all.size()) {}

  VerifyResult result(Crew* crew) {
    const std::size_t count = tasks_.all.size();
    VerifyResult result{options_.samples, options_.line_count(), options_.seed, std::vector<ClaimResult>(count)};
    on_threads(options_.threads, [&] {
      if (options_.certificates) check_certificates(crew);
      sample(crew);
      if (options_.certificates) judge_where_statements_fail();
      judge_lines(crew);
      const std::vector<std::string> conclusions = conclude_open(crew);
      in_parallel(0, count, [&](std::size_t t) {
        result.claims[t] = result_of(tasks_, tasks_.all[t], tallies_[t], read_conclusion(conclusions[t]));
      });
    });
    if (!options_.certificates) return result;
    find_certificates(tasks_.file, result, *options_.certificates);
    result.second_checker = options_.certificates->second_checker();
    find_judgements(tasks_.file, result, *options_.certificates);
    return result;
  }

  std::string answer(std::string_view request) const {
    ByteReader bytes(request);
    bytes.number();  // the paper
    const auto question = static_cast<VerifyQuestion>(bytes.number());
    const std::size_t which = bytes.number();
    if (question == VerifyQuestion::samples) {
      const std::uint64_t begin = bytes.number();
      return judge_samples(tasks_, {which, begin, bytes.number()});
    }
    const ClaimTask& task = tasks_.all.at(which);
    if (question == VerifyQuestion::line) {
      const Line line{bytes.rationals(), bytes.rationals(), bytes.rationals().at(0)};
      ByteWriter tally;
      write_tally(tally, judge_line(tasks_, task, line));
      return tally.take();
    }
    if (question == VerifyQuestion::certificates) {
      return slipproof::check_certificates(tasks_.file, task.claim, task.reading, *options_.certificates);
    }
    return conclusion_bytes(conclude(tasks_, task, read_tally(bytes)));
  }

 private:
  ByteWriter about(VerifyQuestion question, std::uint64_t which) const {
    ByteWriter request;
    request.number(paper_).number(static_cast<std::uint64_t>(question)).number(which);
    return request;
  }
  Service service() const {
    return [this](std::string_view request) { return answer(request); };
  }
  void tell(std::uint64_t done) {
    done_ += done;
    if (options_.progress) options_.progress(done_, total_);
  }

  /// Each request contains a digest of the folder, since a run that is continued may find other certificates there.
  void check_certificates(Crew* crew) {
    const std::string digest = crew != nullptr ? options_.certificates->digest() : std::string();
    share(
        crew, service(), tasks_.all.size(),
        [&](std::uint64_t t) { return about(VerifyQuestion::certificates, t).text(digest).take(); },
        [&](std::uint64_t, const std::string& checked) { options_.certificates->take(checked); });
  }

  void sample(Crew* crew) {
    const std::vector<SamplePiece> pieces = sample_pieces(tasks_);
    const auto request = [&](std::uint64_t i) {
      return about(VerifyQuestion::samples, pieces[i].setting).number(pieces[i].begin).number(pieces[i].end).take();
    };
    share(crew, service(), pieces.size(), request, [&](std::uint64_t i, const std::string& judged) {
      add_tallies(judged, tallies_);
      tell(pieces[i].end - pieces[i].begin);
    });
  }

  /// If `prove` found numbers at which a statement of the claim is false, judges the claim there as one more sample.
  void judge_where_statements_fail() {
    in_parallel(0, tasks_.all.size(), [&](std::size_t t) {
      const ClaimTask& task = tasks_.all[t];
      tallies_[t].fail(failure_of([&] {
        for (const auto& numbers : failing_numbers(tasks_.file, task.claim, task.reading, *options_.certificates)) {
          judge_at(tasks_, task, numbers, tallies_[t]);
        }
      }));
    });
  }

  void judge_lines(Crew* crew) {
    const std::vector<TaskLines> of_tasks = lines_of_tasks(tasks_, tallies_);
    std::vector<std::pair<const TaskLines*, std::uint64_t>> lines;
    for (const TaskLines& its : of_tasks) {
      for (std::uint64_t number = 0; number < its.count; ++number) lines.emplace_back(&its, number);
    }
    total_ = done_ + lines.size();  // exact from here on
    const auto request = [&](std::uint64_t i) {
      const auto& [its, number] = lines[i];
      const Line line = its->line(number, options_.seed);
      ByteWriter bytes = about(VerifyQuestion::line, its->task);
      return bytes.rationals(line.origin).rationals(line.direction).rationals({line.inside}).take();
    };
    share(crew, service(), lines.size(), request, [&](std::uint64_t i, const std::string& judged) {
      ByteReader bytes(judged);
      tallies_[lines[i].first->task].add(read_tally(bytes));
      tell(1);
    });
  }

  /// The conclusions of all tasks.
  std::vector<std::string> conclude_open(Crew* crew) {
    std::vector<std::string> conclusions(tasks_.all.size(), conclusion_bytes({}));
    std::vector<std::size_t> open;
    for (std::size_t t = 0; t < tasks_.all.size(); ++t) {
      if (!is_concluded(tasks_, tasks_.all[t], tallies_[t])) open.push_back(t);
    }
    const auto request = [&](std::uint64_t i) {
      ByteWriter bytes = about(VerifyQuestion::conclusion, open[i]);
      write_tally(bytes, tallies_[open[i]]);
      return bytes.take();
    };
    share(crew, service(), open.size(), request,
          [&](std::uint64_t i, std::string conclusion) { conclusions[open[i]] = std::move(conclusion); });
    return conclusions;
  }

  const VerifyOptions& options_;
  const std::uint64_t paper_;
  const PaperTasks tasks_;
  std::vector<Tally> tallies_;
  std::uint64_t done_ = 0, total_;
};

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
