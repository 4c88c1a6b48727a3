// The slow and complete judgement: every motion, the violated condition, exact margins.
#pragma once

#include "base/parallel/failure.hpp"
#include "records/certify/judge.hpp"

namespace slipproof {

RecordJudgement judge_exactly(const Record& record, const JudgeOptions& options);

RecordJudgement invalid_judgement(const std::string& reason);
RecordJudgement undecided_judgement(const std::string& reason);

/// What `judge` returns. Where it fails the record is undecided, with the reason, and the others go on.
template <class Judge>
RecordJudgement judged_or_undecided(const Judge& judge) {
  RecordJudgement result;
  const std::string failure = failure_of([&] { result = judge(); });
  if (!failure.empty()) result = undecided_judgement(failure);
  return result;
}

/// `needed` is what it would take, if that is known, endless if not.
std::string too_much_work(Work needed, Work effort);

}  // namespace slipproof
