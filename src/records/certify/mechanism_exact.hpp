// The slow and complete judgement of a record of a mechanism, by the kernel.
#pragma once

#include "mechanics/kernel/motions.hpp"
#include "records/certify/judge.hpp"
#include "records/certify/mechanism_answer.hpp"

namespace slipproof {

/// What an answer is, as one point of a mechanism has motions.
struct MechanismVerdict {
  MotionsAtLoad found;
  MechanismMode nearest;  ///< the mode with the solution nearest to the answer; empty: none that the record claims
  Distance distance;      ///< to it
  std::size_t worst = 0;  ///< the answer's component with the largest relative error
  RecordVerdict verdict = RecordVerdict::wrong;
};

/// The verdict that every way to judge a mechanism's answer gives, that of bicycles too. Throws TooMuchWork.
MechanismVerdict judge_at(const MechanismSetting& setting, const MechanismRecord& record,
                          const FrictionProblem& problem, const std::optional<Rational>& load,
                          const JudgeOptions& options);

/// The motion to which a mode belongs; null for one of a continuum.
const MotionAtLoad* motion_with(const MotionsAtLoad& found, const MechanismMode& mode);

/// A number of a record or, where that has none, of what is the same for all.
bool is_given(const MechanismSetting& setting, const MechanismRecord& record, std::size_t parameter);

/// Verdicts as for a bicycle; a record outside the domain is invalid. Errors are relative as contact/yardstick.hpp and
/// MechanismAnswer say. The record is complete, and its numbers are finite.
RecordJudgement judge_exactly(const MechanismSetting& setting, const MechanismRecord& record,
                              const JudgeOptions& options);

}  // namespace slipproof
