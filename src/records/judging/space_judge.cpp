#include "records/judging/space_judge.hpp"

#include <algorithm>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "contact/impact/poisson_in_space.hpp"
#include "contact/space/solve_space.hpp"
#include "records/judging/answer.hpp"
#include "records/judging/forces_near.hpp"

namespace slipproof {

namespace {

constexpr std::size_t kept_points = 64;

Json range_text(const std::optional<Range>& range) {
  return range ? Json::array({exact_text(*range->lower), exact_text(*range->upper)}) : Json(nullptr);
}

/// A record against the motions of its scene.
class SpaceVerdict {
 public:
  SpaceVerdict(const RecordSetting& setting, const Record& record, const RecordPoint& point, const SolvedSpace& solved,
               const JudgeOptions& options)
      : setting_(setting),
        solved_(solved),
        tolerance_(to_rational(options.tolerance)),
        near_(to_rational(options.near)),
        problem_(setting.maker.problem(point.values)),
        answer_(setting, record, problem_, point.load) {
    for (const SpaceMotion& motion : solved.motions) bounds_.push_back(answer_.bounds(motion, near_));
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      if (solved.motions[i].exists && (!best_ || is_nearer(bounds_[i].most, bounds_[*best_].most, tolerance_))) {
        best_ = i;
      }
    }
  }

  RecordJudgement judgement() {
    RecordJudgement result;
    result.verdict = verdict();
    result.motions = solved_.motions.size();
    result.counted = solved_.complete();
    result.continuum = std::ranges::any_of(solved_.motions, &SpaceMotion::is_continuum);
    if (best_) {
      const RecordAnswer::Bounds& bounds = bounds_[*best_];
      result.distance = enclose(bounds.most.scaled).upper;
      if (result.verdict != RecordVerdict::wrong && result.verdict != RecordVerdict::undecided) {
        result.add_mode(no_mode, mode_of(solved_.motions[*best_]));
        result.max_error = enclose(bounds.most.relative).upper;
        result.others_excluded = is_alone(solved_.motions[*best_]);
        if (result.verdict == RecordVerdict::certified && !result.others_excluded) details_["others"] = "not excluded";
      } else if (bounds.most.relative > tolerance_) {
        details_["worst"] = setting_.fields.name(setting_.fields.first_answer() + bounds.worst);
      }
    }
    if (result.verdict == RecordVerdict::inaccurate) {
      details_["worst"] = setting_.fields.name(setting_.fields.first_answer() + bounds_[*best_].worst);
    }
    if (result.verdict != RecordVerdict::certified) add_motions();
    if (!details_.empty()) result.details = "," + inner_json_text(details_);
    return result;
  }

 private:
  static bool is_alone(const SpaceMotion& motion) { return motion.unique || motion.others_within == Rational(0); }

  RecordVerdict undecided(const char* reason) {
    details_["reason"] = reason;
    return RecordVerdict::undecided;
  }

  RecordVerdict verdict() {
    if (best_ && bounds_[*best_].most.relative <= tolerance_) return verdict_within();
    for (const RecordAnswer::Bounds& bounds : bounds_) {
      if (bounds.least.relative <= tolerance_) {
        return undecided("the ranges that are proved for a motion are wider than the tolerance");
      }
    }
    if (!solved_.complete())
      return undecided("no motion that is known is within the tolerance, and there may be others");
    if (best_ && bounds_[*best_].most.scaled <= near_) {
      if (is_alone(solved_.motions[*best_])) return RecordVerdict::inaccurate;
      return undecided("beside the nearest motion there may be others");
    }
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      if (bounds_[i].least.scaled <= near_) return undecided("the ranges that are proved for a motion are too wide");
      if (solved_.motions[i].is_continuum()) return undecided("it may be another motion of a continuum");
      if (!is_alone(solved_.motions[i]) && !bounds_[i].far_from_others) {
        return undecided("it may be near one that counts as a motion that is known");
      }
    }
    return RecordVerdict::wrong;
  }

  /// Of an answer that is a motion by all that is compared.
  RecordVerdict verdict_within() {
    if (bounds_[*best_].open_force && !has_right_forces()) {
      return undecided("the accelerations are a motion's, which leaves its forces open, and none near these are found");
    }
    const auto exist = static_cast<std::size_t>(std::ranges::count_if(solved_.motions, &SpaceMotion::exists));
    if (exist > 1 || solved_.motions[*best_].is_continuum()) return RecordVerdict::ambiguous;
    if (solved_.complete() && exist == solved_.motions.size()) return RecordVerdict::certified;
    return undecided("it is a motion, and there may be others");
  }

  /// Whether forces that are open are within the tolerance of some that the law allows.
  bool has_right_forces() {
    const SpaceMotion& motion = solved_.motions[*best_];
    const auto forces = forces_near(solved_, motion, answer_.forces_beside(motion));
    if (!forces) return false;
    const RecordAnswer::Bounds bounds = answer_.bounds(motion, near_, *forces);
    if (bounds.open_force || bounds.most.relative > tolerance_) return false;
    bounds_[*best_] = bounds;
    return true;
  }

  void add_motions() {
    Json found = Json::array();
    for (const SpaceMotion& motion : solved_.motions) {
      Json accelerations = Json::object(), forces = Json::object();
      const auto& fields = setting_.fields;
      for (std::size_t i = 0; i < motion.accelerations.size(); ++i) {
        accelerations[fields.name(fields.first_answer() + i)] = range_text(motion.accelerations[i]);
      }
      for (std::size_t i = 0; i < motion.forces.size(); ++i) {
        forces[fields.name(fields.first_answer() + fields.accelerations() + i)] = range_text(motion.forces[i]);
      }
      found.push_back({{"modes", Json::array({mode_of(motion)})},
                       {"status", motion.strict ? "strict" : "boundary"},
                       {"exists", motion.exists},
                       {"unique", motion.unique},
                       {"open_directions", motion.open_directions ? Json(*motion.open_directions) : Json(nullptr)},
                       {"accelerations", std::move(accelerations)},
                       {"forces", std::move(forces)}});
    }
    details_["complete"] = solved_.complete();
    details_["found"] = std::move(found);
  }

  const RecordSetting& setting_;
  const SolvedSpace& solved_;
  const Rational tolerance_, near_;
  const FrictionProblem problem_;
  const RecordAnswer answer_;
  std::vector<RecordAnswer::Bounds> bounds_;  ///< by motion
  std::optional<std::size_t> best_;           ///< the nearest motion that is proved to exist
  Json details_ = Json::object();
};

}  // namespace

std::shared_ptr<const SolvedSpace> SpaceMemory::motions(const RecordSetting& setting, const RecordPoint& point,
                                                        const JudgeOptions& options) const {
  {
    const std::lock_guard lock(mutex_);
    const auto known = std::ranges::find_if(known_, [&](const auto& one) { return one.first == point; });
    if (known != known_.end()) return known->second;
  }
  // Not under the lock: the search runs in parallel, and its threads may judge other records while they wait.
  const Mechanism& mechanism = setting.certified.mechanism;
  CompleteOptions effort;  // whose own default is for scenes
  if (options.effort != JudgeOptions().effort) effort.effort = options.effort;
  MechanismScene scene{mechanism.name, mechanism, point.values, point.load, {}};
  const bool phases = mechanism.impact && mechanism.impact->law == ImpactLaw::poisson;
  auto solved = std::make_shared<const SolvedSpace>(phases ? solve_poisson_in_space(std::move(scene), effort).space
                                                           : solve_space(std::move(scene), effort));
  const std::lock_guard lock(mutex_);
  known_.emplace_front(point, solved);
  if (known_.size() > kept_points) known_.pop_back();
  return solved;
}

RecordJudgement SpaceMemory::judge(const RecordSetting& setting, const Record& record, const RecordPoint& point,
                                   const JudgeOptions& options) const {
  return judged_or_undecided([&] {
    const auto solved = motions(setting, point, options);
    return SpaceVerdict(setting, record, point, *solved, options).judgement();
  });
}

}  // namespace slipproof
