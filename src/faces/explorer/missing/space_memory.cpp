// Records of scenes in space, which the page does not judge: all that finds their motions is left out.
#include "base/input/diagnostic.hpp"
#include "records/judging/space_judge.hpp"

namespace slipproof {

RecordJudgement SpaceMemory::judge(const RecordSetting&, const Record&, const RecordPoint&, const JudgeOptions&) const {
  return undecided_judgement("the page judges records in the plane; `slipproof certify` those in space");
}

}  // namespace slipproof
