// The slow and complete judgement of a record of a mechanism, by the kernel.
#pragma once

#include "certify/judge.hpp"
#include "certify/mechanism_record.hpp"

namespace slipproof {

/// What is judged, ready for many records; shared by threads.
struct MechanismSetting {
  const CertifiedMechanism& certified;
  const MechanismFields& fields;
  const ProblemMaker& maker;
};

/// A number of a record or, where that has none, of what is the same for all.
bool is_given(const MechanismSetting& setting, const MechanismRecord& record, std::size_t parameter);

/// Verdicts as for a bicycle; a record outside the domain is invalid. Undetermined forces are held against the solution
/// that has the answer's own, one after the other as far as their exact ranges allow. The relative error of a component
/// that is exactly 0 is held against the largest unknown acceleration without forces of contacts and friction elements,
/// or the largest force that the equations apply; where that is 0, against the motion's largest component of its kind.
/// So is that of an undetermined component, unless it is larger itself.
/// The record is complete, and its numbers are finite.
RecordJudgement judge_exactly(const MechanismSetting& setting, const MechanismRecord& record,
                              const JudgeOptions& options);

}  // namespace slipproof
