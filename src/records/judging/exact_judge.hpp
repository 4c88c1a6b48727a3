// The slow but complete judgement of a record by the kernel: every motion, the violated condition, exact margins.
#pragma once

#include "records/judging/judge.hpp"
#include "records/record/point.hpp"

namespace slipproof {

/// A record outside the domain is invalid. Relative errors are as defined in contact/yardstick.hpp and RecordAnswer.
/// The record must be complete, and its numbers finite.
RecordJudgement judge_exactly(const RecordSetting& setting, const Record& record, const JudgeOptions& options);

}  // namespace slipproof
