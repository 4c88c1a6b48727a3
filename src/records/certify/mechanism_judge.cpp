#include "records/certify/mechanism_judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/number/binary64.hpp"
#include "records/certify/lane_errors.hpp"

namespace slipproof {

namespace {

/// The answers of a block in one field, and which of its records have one.
struct LaneAnswers {
  RunningError value;
  LaneBits present{};
};

LaneAnswers answers_in(const std::vector<MechanismRecord>& records, std::size_t field) {
  LaneAnswers result;
  for (std::size_t lane = 0; lane < records.size(); ++lane) {
    if (!records[lane].present[field]) continue;
    const double value = records[lane].values[field];
    result.present[lane] = -1;
    result.value.value[lane] = value;
    if (!records[lane].is_exact(field)) result.value.error[lane] = std::fabs(value) * batch_rounding + batch_underflow;
  }
  return result;
}

/// Forces that a mode leaves free, found from those that an answer has.
class FreeForces {
 public:
  explicit FreeForces(std::size_t free) : free_(free) {}

  /// A force of the answer that varies with what is free.
  void take(const LaneForm& form, const LaneAnswers& answer) {
    asked_ |= answer.present;
    const RunningError rest = answer.value - form.constant;
    if (free_ == 1) {
      const RunningError value = rest / form.slopes[0];
      put(values_[0], value, answer.present & ~known_);
      known_ |= answer.present;
    } else if (free_ == 2) {
      take_of_two(form, rest, answer.present);
    }
  }

  /// Records whose answers say nothing of what is free, or all of it.
  LaneBits settled() const { return ~asked_ | known_; }
  LaneBits asked() const { return asked_; }
  std::span<const RunningError> values() const { return std::span(values_).first(std::min<std::size_t>(free_, 2)); }

 private:
  static void put(RunningError& to, const RunningError& from, const LaneBits& mask) {
    to.value = chosen(mask, from.value, to.value);
    to.error = chosen(mask, from.error, to.error);
  }

  /// The first force is kept, the next that says something else gives both.
  void take_of_two(const LaneForm& form, const RunningError& rest, const LaneBits& present) {
    const RunningError &x = form.slopes[0], &y = form.slopes[1];
    const RunningError determinant = first_[0] * y - first_[1] * x;
    const LaneBits solves = present & has_first_ & ~known_ & surely_not_zero(determinant);
    put(values_[0], (first_rest_ * y - first_[1] * rest) / determinant, solves);
    put(values_[1], (first_[0] * rest - first_rest_ * x) / determinant, solves);
    known_ |= solves;
    const LaneBits is_first = present & ~has_first_;
    put(first_[0], x, is_first);
    put(first_[1], y, is_first);
    put(first_rest_, rest, is_first);
    has_first_ |= is_first;
  }

  std::size_t free_;
  LaneBits asked_{}, known_{}, has_first_{};
  std::array<RunningError, 2> values_{}, first_{};
  RunningError first_rest_;
};

}  // namespace

MechanismJudge::MechanismJudge(const CertifiedMechanism& certified, const MechanismFields& fields)
    : certified_(certified), fields_(fields), maker_(certified.mechanism), kinds_(certified.mechanism) {}

const MechanismBatch& MechanismJudge::batch(const std::vector<bool>& given) const {
  const std::lock_guard lock(mutex_);
  auto& batch = batches_[given];
  if (!batch) batch = std::make_unique<const MechanismBatch>(certified_.mechanism, certified_.values.starts, given);
  return *batch;
}

MechanismBlock::Number MechanismBlock::number_of(const Rational& x) {
  const double nearest = nearest_binary64(x);
  return {nearest, std::isfinite(nearest) && to_rational(nearest) == x};
}

MechanismBlock::MechanismBlock(const MechanismJudge& judge, const JudgeOptions& options)
    : judge_(judge), setting_(judge.setting()), options_(options), records_(lane_count) {
  const CertifiedMechanism& certified = setting_.certified;
  for (const Rational& value : certified.values.parameters) base_.push_back(number_of(value));
  base_.push_back(number_of(certified.load.value_or(0)));
  for (const MechanismValues::Circle& at : certified.values.angles) {
    constexpr double half_turn = std::numeric_limits<double>::quiet_NaN();  // nothing is sure of it
    base_angles_.push_back(at.cosine == -1 ? Number{half_turn, false} : number_of(at.sine / (1 + at.cosine)));
  }
  for (MechanismRecord& record : records_) record.clear(setting_.fields.size());
}

void MechanismBlock::add(MechanismRecord& record, RecordJudgement& judgement) {
  std::vector<bool> given(setting_.fields.parameters());
  for (std::size_t i = 0; i < given.size(); ++i) given[i] = is_given(setting_, record, i);
  if (batch_ == nullptr || batch_->given() != given) {
    finish();
    use(judge_.batch(given));
  }
  std::swap(records_[judgements_.size()], record);
  judgements_.push_back(&judgement);
  if (judgements_.size() == lane_count) finish();
}

void MechanismBlock::use(const MechanismBatch& batch) {
  batch_ = &batch;
  names_.clear();
  for (const MechanismMode& mode : batch.modes()) names_.push_back('"' + name(mode) + '"');
  run_ = batch.code() == nullptr ? nullptr : std::make_unique<ModeRun>(*batch.code());
}

void MechanismBlock::finish() {
  if (judgements_.empty()) return;
  for (RecordJudgement* judgement : judgements_) judgement->verdict = RecordVerdict::invalid;
  if (run_) decide();
  for (std::size_t lane = 0; lane < judgements_.size(); ++lane) {
    RecordJudgement& judgement = *judgements_[lane];
    if (judgement.verdict == RecordVerdict::certified) continue;
    judgement = judge_exactly(setting_, records_[lane], options_);
  }
  judgements_.clear();
}

std::optional<MechanismBlock::Number> MechanismBlock::angle(const MechanismRecord& record, std::size_t index) const {
  bool own = false;
  for (std::size_t form = 0; form < MechanismFields::angle_forms; ++form) {
    own = own || record.present[setting_.fields.angle(index, MechanismFields::AngleForm{form})];
  }
  if (!own) return base_angles_[index];
  std::string mistake;
  const RecordAngle angle = angle_of(record, setting_.fields, index, mistake);
  if (angle.half_turn || !mistake.empty()) return std::nullopt;
  return Number{angle.nearest, !angle.exact};
}

/// False where the record is none for binary64.
bool MechanismBlock::put(const MechanismRecord& record, std::size_t lane) {
  const MechanismFields& fields = setting_.fields;
  const ModePrograms& programs = batch_->code()->programs();
  const auto set = [&](std::size_t input, std::optional<std::size_t> field) {
    const bool own = field && record.present[*field];
    const Number& base = base_[input < fields.parameters() ? input : fields.parameters()];
    const Number number = own ? Number{record.values[*field], record.is_exact(*field)} : base;
    run_->set(input, lane, number.nearest, number.exact);
  };
  for (std::size_t i = 0; i < fields.parameters(); ++i) set(i, i);
  set(programs.load(), fields.load());
  for (std::size_t i = 0; i < fields.angles(); ++i) {
    const auto number = angle(record, i);
    if (!number) return false;
    run_->set_angle(i, lane, number->nearest, number->exact);
  }
  return true;
}

void MechanismBlock::decide() {
  LaneBits usable{};
  for (std::size_t lane = 0; lane < judgements_.size(); ++lane) usable[lane] = put(records_[lane], lane) ? -1 : 0;
  run_->decide();
  usable &= run_->in_domain() & run_->in_load_domain();
  std::array<std::optional<std::size_t>, lane_count> motions;
  std::vector<std::size_t> modes;
  for (std::size_t lane = 0; lane < judgements_.size(); ++lane) {
    if (usable[lane] != 0) motions[lane] = claimed_motion(lane);
    if (motions[lane] && std::find(modes.begin(), modes.end(), *motions[lane]) == modes.end()) {
      modes.push_back(*motions[lane]);
    }
  }
  if (!modes.empty()) run_->compute_scales();
  for (const std::size_t mode : modes) {
    const Lanes error = answer_error(mode, run_->compute_values(mode));
    for (std::size_t lane = 0; lane < judgements_.size(); ++lane) {
      if (motions[lane] == mode && error[lane] <= options_.tolerance) certify(lane, mode, error[lane]);
    }
  }
}

/// The only motion, by the strict mode that the record claims, or any.
std::optional<std::size_t> MechanismBlock::claimed_motion(std::size_t lane) const {
  const auto mode = run_->only_motion(lane);
  if (!mode || records_[lane].mode == nullptr) return mode;
  for (std::size_t i = *mode; i < batch_->modes().size(); ++i) {
    if (batch_->modes()[i] != *records_[lane].mode) continue;
    const bool same = run_->is_same_motion(*mode, i) && run_->modes()[i].strict[lane] != 0;
    return same ? std::optional(i) : std::nullopt;
  }
  return std::nullopt;
}

/// Of each record, against the motion of a mode: an upper bound on the largest relative error of a component.
Lanes MechanismBlock::answer_error(std::size_t mode, const ModeRun::Values& values) const {
  const ModePrograms& programs = batch_->code()->programs();
  const ModeProgram& program = programs.programs[mode];
  const MechanismFields& fields = setting_.fields;
  FreeForces free(program.free);
  Lanes error{};
  std::vector<LaneAnswers> forces;
  for (std::size_t i = 0; i < program.forces.size(); ++i) {
    forces.push_back(answers_in(records_, fields.first_answer() + fields.accelerations() + i));
    if (program.forces[i].varies()) free.take(values.forces[i], forces.back());
  }
  LaneBits inside = free.settled();
  for (const LaneForm& condition : values.conditions) {
    inside &= ~free.asked() | surely_not_negative(condition.at(free.values()));
  }
  const std::vector<Lanes> yardsticks = least_yardsticks(*run_, programs);
  const auto compare = [&](const LaneAnswers& answer, const RunningError& exact, std::size_t kind,
                           const SolvedForm& form, const LaneForm& at) {
    LaneBits open{};
    for (std::size_t k = 0; k < free.values().size(); ++k) open |= surely_not_zero(at.slopes[k]);
    const Lanes relative = relative_error(answer.value, exact, yardsticks[kind], form.varies(), open);
    error = worse(error, chosen(answer.present, relative, Lanes{}));
  };
  for (std::size_t i = 0; i < program.accelerations.size(); ++i) {
    const LaneForm& at = values.accelerations[i];
    compare(answers_in(records_, fields.first_answer() + i), at.constant, programs.kinds.accelerations[i],
            program.accelerations[i], at);
  }
  for (std::size_t i = 0; i < program.forces.size(); ++i) {
    const LaneForm& at = values.forces[i];
    compare(forces[i], at.at(free.values()), programs.kinds.forces[i], program.forces[i], at);
  }
  return chosen(inside, error, Lanes{} + infinite);
}

void MechanismBlock::certify(std::size_t lane, std::size_t mode, double error) {
  RecordJudgement& judgement = *judgements_[lane];
  judgement = {};
  judgement.verdict = RecordVerdict::certified;
  judgement.tier = Tier::filter;
  judgement.motions = 1;
  judgement.max_error = error;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (run_->modes()[i].strict[lane] == 0 || !run_->is_same_motion(mode, i)) continue;
    if (!judgement.mode_names.empty()) judgement.mode_names += ',';
    judgement.mode_names += names_[i];
  }
}

}  // namespace slipproof
