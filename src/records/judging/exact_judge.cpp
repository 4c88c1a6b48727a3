#include "records/judging/exact_judge.hpp"

#include <algorithm>

#include "base/number/binary64.hpp"
#include "base/output/json.hpp"
#include "mechanics/kernel/kinematic_modes.hpp"
#include "mechanics/points/sampling.hpp"
#include "records/judging/answer.hpp"
#include "records/judging/explanation.hpp"
#include "records/judging/space_judge.hpp"

namespace slipproof {

/// The point of a record, and what the kernel finds there, each when it is first needed.
class KnownPoint {
 public:
  /// Throws NoValue.
  KnownPoint(const RecordSetting& setting, RecordPoint point)
      : point_(std::move(point)),
        problem_(setting.maker.problem(point_.values)),
        solved_(without_equations(problem_)) {}

  const RecordPoint& point() const { return point_; }
  const FrictionProblem& problem() const { return problem_; }
  /// With the equations solved.
  const FrictionProblem& solved() const { return solved_; }
  /// All, with a bound on the effort where there are more modes than are tried; null where it does not do.
  const MotionsAtLoad* motions() {
    try {
      if (!motions_ && !took_too_much_) motions_ = motions_of(solved_, point_.load);
    } catch (const TooMuchWork&) {
      took_too_much_ = true;
    }
    return motions_ ? &*motions_ : nullptr;
  }
  const std::vector<ConsistentMode>& modes() {
    if (!modes_) modes_ = consistent_modes(problem_, point_.load);
    return *modes_;
  }

 private:
  RecordPoint point_;
  FrictionProblem problem_, solved_;
  std::optional<MotionsAtLoad> motions_;
  std::optional<std::vector<ConsistentMode>> modes_;
  bool took_too_much_ = false;
};

namespace {

/// Estimates the work. The numbers are quotients of polynomials in the record's numbers; their digits are at most all
/// digits of these, times the degree.
Work work_of(const RecordSetting& setting, const RecordPoint& point) {
  const Mechanism& mechanism = setting.certified.mechanism;
  constexpr std::size_t degree = 4;
  std::size_t bits = point.load ? bit_count(*point.load) : 0;
  for (const Rational& value : point.values.parameters) bits += bit_count(value);
  for (const auto& angle : point.values.angles) bits += bit_count(angle.cosine) + bit_count(angle.sine);
  const auto kinds = element_kinds(mechanism, point.values.starts, point.values.given);
  const auto modes = static_cast<Work>(std::min(mode_count(kinds), max_tried));
  const Work unknowns = mechanism.unknowns.size();
  return times(times(modes, unknowns * unknowns), product_work(degree * bits));
}

const MotionsAtLoad nothing_found;

/// The verdict on an answer at a point whose motions are known.
struct ExactVerdict {
  const MotionsAtLoad* found = &nothing_found;
  /// The mode with the solution nearest to the answer; empty: there is none that the record claims.
  MechanismMode nearest;
  Distance distance;      ///< to it
  std::size_t worst = 0;  ///< the component of the answer with the largest relative error
  RecordVerdict verdict = RecordVerdict::wrong;
  std::string unexamined;  ///< why not all motions were looked for; `found` is empty then
};

/// The motion that a mode belongs to; null for a mode of a continuum.
const MotionAtLoad* motion_with(const MotionsAtLoad& found, const MechanismMode& mode) {
  for (const MotionAtLoad& motion : found.motions) {
    for (const auto* modes : {&motion.modes, &motion.boundary_modes}) {
      if (std::find(modes->begin(), modes->end(), mode) != modes->end()) return &motion;
    }
  }
  return nullptr;
}

/// The solutions of some modes, the nearest of which counts.
void find_nearest(const std::vector<ConsistentMode>& modes, const RecordAnswer& answer, const JudgeOptions& options,
                  Effort& effort, ExactVerdict& result) {
  for (const ConsistentMode& mode : modes) {
    std::size_t worst = 0;
    Distance distance = answer.distance(mode, effort, worst);
    if (!result.nearest.empty() && !is_nearer(distance, result.distance, to_rational(options.tolerance))) continue;
    result.nearest = mode.mode;
    result.distance = std::move(distance);
    result.worst = worst;
  }
}

/// The answer's own mode first: of many modes the others are tried only where they matter.
ExactVerdict judge_at(const RecordSetting& setting, const Record& record, KnownPoint& known,
                      const std::optional<MechanismMode>& own, const JudgeOptions& options) {
  ExactVerdict result;
  const auto& load = known.point().load;
  const RecordAnswer answer(setting, record, known.problem(), load);
  Effort effort(options.effort);
  const bool claimed = record.mode != no_mode, many = has_too_many_to_try(known.problem());
  const auto near = [&] { return !result.nearest.empty() && result.distance.scaled <= to_rational(options.near); };
  if (own && (claimed || many)) {
    find_nearest(mode_of(known.problem(), *own, load).consistent, answer, options, effort, result);
  }
  if (many && claimed && !near()) {
    result.unexamined = "the other modes: the answer's own decides";
    return result;
  }
  if (const MotionsAtLoad* all = known.motions()) {
    result.found = all;
  } else {
    result.unexamined = "the other modes: " + too_much_work(unlimited, kinematic_effort);
  }
  if (!claimed && result.unexamined.empty() && !near()) {
    find_nearest(known.modes(), answer, options, effort, result);
  }
  if (!near()) {
    if (!claimed && !result.unexamined.empty()) result.verdict = RecordVerdict::undecided;
    return result;
  }
  const bool several = result.found->motions.size() > 1 || !result.found->continua.empty();
  result.verdict = result.distance.relative > to_rational(options.tolerance) ? RecordVerdict::inaccurate
                   : !result.unexamined.empty()                              ? RecordVerdict::undecided
                   : several                                                 ? RecordVerdict::ambiguous
                                                                             : RecordVerdict::certified;
  return result;
}

RecordJudgement judge_point(const RecordSetting& setting, const Record& record, KnownPoint& known,
                            const JudgeOptions& options) {
  const RecordPoint& point = known.point();
  std::optional<MechanismMode> own;
  if (record.mode != no_mode) {
    own = setting.fields.modes().mode(record.mode);
  } else if (has_too_many_to_try(known.problem())) {
    own = Explanation(setting, known.solved(), nothing_found, point.load).guess_mode(record);
  }
  const ExactVerdict judged = judge_at(setting, record, known, own, options);
  const MotionsAtLoad& found = *judged.found;
  RecordJudgement result;
  result.verdict = judged.verdict;
  result.motions = found.motions.size();
  result.counted = judged.unexamined.empty();
  result.continuum = !found.continua.empty();
  if (!judged.nearest.empty()) result.distance = enclose(judged.distance.scaled).upper;
  Json details = Json::object();
  const Explanation explanation(setting, known.solved(), found, point.load);
  if (result.verdict == RecordVerdict::wrong) {
    if (record.mode != no_mode) {
      explanation.add_claimed(details, setting.fields.modes().mode(record.mode), point.values);
    } else {
      explanation.add_likely(details, record, point.values);
    }
  } else {
    const MotionAtLoad* motion = motion_with(found, judged.nearest);
    const std::vector<MechanismMode> modes = motion == nullptr  ? std::vector<MechanismMode>(1, judged.nearest)
                                             : motion->strict() ? motion->modes
                                                                : motion->boundary_modes;
    for (const MechanismMode& mode : modes) {
      const std::string text = name(mode);
      result.add_mode(setting.fields.find_mode(text).value_or(no_mode), text);
    }
    result.max_error = enclose(judged.distance.relative).upper;
    if (result.verdict == RecordVerdict::inaccurate) {
      details["worst"] = setting.fields.name(setting.fields.first_answer() + judged.worst);
    }
  }
  if (!judged.unexamined.empty()) {
    details["unexamined"] = judged.unexamined;
  } else if (result.verdict != RecordVerdict::certified) {
    explanation.add_motions(details);
  }
  if (!details.empty()) result.details = "," + inner_json_text(details);
  return result;
}

RecordJudgement undecided_record(Work needed, const JudgeOptions& options) {
  return undecided_judgement(too_much_work(needed, options.effort));
}

/// The energy before an impact, what the answer adds to it, and whether that is more than the tolerance.
std::string energy_members(const RecordSetting& setting, const Record& record, const RecordPoint& point,
                           double tolerance) {
  const ImpactEnergy energy(setting.certified.mechanism, setting.maker, point.values, point.load);
  const Rational work = energy_gained(energy, record, setting.fields.first_answer());
  const bool known = !energy.is_driven() && abs(work) > to_rational(tolerance) * energy.before();
  const Json members{{"energy",
                      {{"before", nearest_binary64(energy.before())},
                       {"work", nearest_binary64(work)},
                       {"gains", known ? Json(work.sign() > 0) : Json()}}}};
  return "," + inner_json_text(members);
}

}  // namespace

Rational energy_gained(const ImpactEnergy& energy, const Record& record, std::size_t first_answer) {
  std::vector<Rational> after;
  for (std::size_t i = 0; i < energy.velocities().size(); ++i) after.push_back(record.exactly(first_answer + i));
  return energy.of(after) - energy.before();
}

ExactJudge::ExactJudge(const RecordSetting& setting, const JudgeOptions& options, const SpaceMemory& in_space)
    : setting_(setting), options_(options), in_space_(in_space) {}
ExactJudge::~ExactJudge() = default;

RecordJudgement ExactJudge::operator()(const Record& record) {
  RecordJudgement result = judge(record);
  if (!setting_.certified.mechanism.impact || result.verdict == RecordVerdict::invalid) return result;
  result.details += energy_members(setting_, record, point_of(setting_, record), options_.tolerance);
  return result;
}

RecordJudgement ExactJudge::judge(const Record& record) {
  if (record.not_finite) return invalid_judgement(record.not_finite->reason);
  RecordPoint point = point_of(setting_, record);
  if (!point.mistake.empty()) return invalid_judgement(point.mistake);
  const bool is_known = known_ && known_->point() == point;
  if (!is_known) {
    if (const std::string reason = outside_domain(setting_, point); !reason.empty()) return invalid_judgement(reason);
    if (setting_.certified.mechanism.dimension == 3) return in_space_.judge(setting_, record, point, options_);
    const Work needed = work_of(setting_, point);
    if (needed > options_.effort) return undecided_record(needed, options_);
  }
  return judged_or_undecided([&] {
    try {
      if (!is_known) known_ = std::make_unique<KnownPoint>(setting_, std::move(point));
      return judge_point(setting_, record, *known_, options_);
    } catch (const NoValue& error) {
      return invalid_judgement(error.what());
    } catch (const TooMuchWork&) {
      return undecided_record(unlimited, options_);
    }
  });
}

}  // namespace slipproof
