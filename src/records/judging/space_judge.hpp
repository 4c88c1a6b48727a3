// The judgement of a record of a scene in space, by the list of all of its motions.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <utility>

#include "contact/space/solved_space.hpp"
#include "records/judging/judge.hpp"
#include "records/record/point.hpp"

namespace slipproof {

/// The motions at the points of records that came last: they are found once for each. Thread-safe.
class SpaceMemory {
 public:
  /// At a point of the domain. Right is what holds wherever in its ranges a motion is; where the ranges, motions that
  /// may be left, or forces that the motion leaves open do not allow a verdict, it is undecided.
  RecordJudgement judge(const RecordSetting& setting, const Record& record, const RecordPoint& point,
                        const JudgeOptions& options) const;

 private:
  /// Throws InputError, NoValue, and std::runtime_error in a build without Clp.
  std::shared_ptr<const SolvedSpace> motions(const RecordSetting& setting, const RecordPoint& point,
                                             const JudgeOptions& options) const;

  mutable std::mutex mutex_;
  mutable std::deque<std::pair<RecordPoint, std::shared_ptr<const SolvedSpace>>> known_;  ///< the newest first
};

}  // namespace slipproof
