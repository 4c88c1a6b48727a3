// The slow but complete judgement of a record by the kernel: every motion, the violated condition, exact margins.
#pragma once

#include <memory>

#include "mechanics/impact/impact_energy.hpp"
#include "records/judging/judge.hpp"
#include "records/record/point.hpp"

namespace slipproof {

class KnownPoint;
class SpaceMemory;

/// Judges records exactly, in space by all motions (space_judge.hpp). Reuses the results at a point for the next record
/// if it has the same point. Not for use by several threads.
class ExactJudge {
 public:
  /// References in `setting`, and `in_space`, must outlive it.
  ExactJudge(const RecordSetting& setting, const JudgeOptions& options, const SpaceMemory& in_space);
  ~ExactJudge();

  /// A record outside the domain, or with a number that is not finite, is invalid. Relative errors are as defined in
  /// contact/problem/yardstick.hpp and RecordAnswer. The record must be complete.
  /// Of an impact there is the energy, too.
  RecordJudgement operator()(const Record& record);

 private:
  RecordJudgement judge(const Record& record);

  RecordSetting setting_;
  JudgeOptions options_;
  const SpaceMemory& in_space_;
  std::unique_ptr<KnownPoint> known_;  ///< point of the previous record
};

/// The kinetic energy that the velocities of a record add to that before its impact. They begin at `first_answer`.
Rational energy_gained(const ImpactEnergy& energy, const Record& record, std::size_t first_answer);

}  // namespace slipproof
