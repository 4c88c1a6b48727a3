// What a run in continuous integration fails for, as its servers read it: JUnit's XML, and SARIF 2.1.0.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "records/certify/certify.hpp"

namespace slipproof {

/// Which verdicts fail.
class FailingVerdicts {
 public:
  /// All but `certified`.
  FailingVerdicts() { fails_.fill(true), fails_[static_cast<std::size_t>(RecordVerdict::certified)] = false; }
  /// Those that are named, and `invalid`: what could not be judged is never right. `eps-solution` is a name, too.
  /// Throws std::invalid_argument for other words.
  explicit FailingVerdicts(const std::vector<std::string>& names);

  bool operator()(RecordVerdict verdict) const { return fails_[static_cast<std::size_t>(verdict)]; }
  /// Where `ambiguous` is named, a certified answer fails, too, unless it is proved to be the only one.
  bool operator()(const RecordJudgement& judgement) const {
    if (judgement.eps_solution) return eps_;
    return (*this)(judgement.verdict) ||
           (only_ && judgement.verdict == RecordVerdict::certified && !judgement.others_excluded);
  }
  /// Whether anything that was counted fails.
  bool operator()(const CertifySummary& summary) const;

 private:
  std::array<bool, record_verdict_count> fails_{};
  bool only_ = false, eps_ = true;
};

/// A record, or an answer, that fails: its number, the word for --fail-on, and its line of output.
struct GateFailure {
  std::uint64_t record = 0;
  std::string verdict;
  std::string line;
};

/// A run: the counts, and of what failed the first `most_listed`.
struct GateRun {
  static constexpr std::size_t most_listed = 1000;

  std::string file;
  std::uint64_t records = 0, failed = 0;
  std::vector<GateFailure> listed;

  void add(std::uint64_t record, const RecordJudgement& judgement, const FailingVerdicts& fails);
};

/// For a log: how many fail, and of the first ten which and why, a line each. `2 of 10 records fail` and its lines.
std::string gate_text(const GateRun& run);
/// A suite with a case for each failure, by the title of its problem, and one for all others together.
std::string junit(const GateRun& run);
/// A result for each failure, with the file as its place and the record's number among its properties.
std::string sarif(const GateRun& run);

}  // namespace slipproof
