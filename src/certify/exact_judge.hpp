// The slow and complete judgement: every motion, the violated condition, exact margins.
#pragma once

#include "certify/judge.hpp"

namespace slipproof {

RecordJudgement judge_exactly(const Record& record, const JudgeOptions& options);

RecordJudgement invalid_judgement(const std::string& reason);

/// `needed` is what it would take, if that is known, endless if not.
std::string too_much_work(Work needed, Work effort);

}  // namespace slipproof
