#include "floating/tape/mode_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "floating/lanes/vector_kernel.hpp"
#include "floating/tape/free_interval.hpp"
#include "floating/tape/truth.hpp"

namespace slipproof {

namespace {

LaneBits all_lanes() {
  return ~LaneBits{};
}

/// The numbers of a form on the solution of a mode, each changed by change().
template <class At, class Change>
LaneForm lane_form(const LinearMode<RunningError>& solution, const SolvedForm& form, const At& at,
                   const Change& change) {
  LaneForm result;
  result.constant = change(solution.constant(form, at));
  for (std::size_t k = 0; k < std::min(form.no_slope.size(), result.slopes.size()); ++k) {
    result.slopes[k] = change(solution.slope(form, k, at));
  }
  return result;
}

/// Judges a mode that leaves nothing free, by its conditions as they are.
void judge_determined(const ModeProgram& program, const LaneForm* conditions, LaneModes& result) {
  LaneBits holds = all_lanes(), zero{}, strict = program.never_strict ? LaneBits{} : all_lanes();
  for (std::size_t i = 0; i < program.conditions.size(); ++i) {
    const RunningError& value = conditions[i].constant;
    const LaneBits positive = surely_positive(value), vanishes = surely_zero(value);
    strict &= positive;
    zero |= vanishes;
    holds &= positive | vanishes;
  }
  result.strict = strict;
  result.boundary = holds & (program.never_strict ? all_lanes() : zero);
}

void judge_with_free(const ModeProgram& program, const LaneForm* conditions, LaneBits& violated, LaneModes& result) {
  std::vector<HalfSpace> sides;
  for (std::size_t i = 0; i < program.conditions.size(); ++i) {
    if (!program.conditions[i].varies()) continue;
    sides.push_back({conditions[i].constant, conditions[i].slopes, all_lanes()});
  }
  std::array<RunningError, 2> inside;
  if (program.free == 2) {
    const FreeInterval interval = interval_of(without_first(sides), 1);
    violated |= interval.lowest > interval.highest;
    inside[1].value = interval.inside();
    for (HalfSpace& side : sides) side.constant = side.constant + side.slopes[1] * inside[1];
  }
  const FreeInterval interval = interval_of(sides, 0);
  if (program.free == 1) violated |= interval.lowest > interval.highest;
  inside[0].value = interval.inside();
  LaneBits holds = all_lanes();
  for (std::size_t i = 0; i < program.conditions.size(); ++i) {
    holds &= surely_positive(conditions[i].at(std::span(inside).first(program.free)));
  }
  result.strict = program.never_strict ? LaneBits{} : holds;
  result.boundary = program.never_strict ? holds : LaneBits{};
}

struct TapeKernel {
  template <int width>
  static void run(const TapeCode& code, RunningError* results) {
    run_code(code, results);
  }
};

}  // namespace

RunningError LaneForm::at(std::span<const RunningError> free) const {
  RunningError value = constant;
  for (std::size_t k = 0; k < std::min(free.size(), slopes.size()); ++k) value = value + slopes[k] * free[k];
  return value;
}

/// Uses as many lanes as the widest registers hold; the compiler splits them for narrower registers.
struct JudgeKernel {
  template <int width>
  static void run(ModeRun& run) {
    run.compute_angles();
    run_code(run.code_->decision(), run.results_.data());
    run.find_domain();
    const auto at = [&](TapeRef ref) -> const RunningError& { return run.at(ref); };
    std::vector<LaneForm>& conditions = run.conditions_;
    const auto& programs = run.code_->programs().programs;
    for (std::size_t i = 0; i < programs.size(); ++i) {
      const LinearMode<RunningError> solution(programs[i], at);
      LaneBits valid = run.in_domain_, orientation{};
      if (solution.divides()) {
        valid &= surely_not_zero(solution.divisor());
        orientation = bits(solution.divisor().value) & sign_bit<Lanes>();
      }
      for (const TapeRef pivot : programs[i].pivots) valid &= surely_not_zero(at(pivot));
      LaneForm* condition = conditions.data();
      for (const SolvedForm& form : programs[i].conditions) {
        *condition++ = lane_form(solution, form, at, [&](const RunningError& x) {
          return RunningError{from_bits(LaneBits(bits(x.value) ^ orientation)), x.error};
        });
      }
      run.modes_[i] = run.judge(programs[i], valid);
    }
  }
};

struct ValuesKernel {
  template <int width>
  static void run(ModeRun& run, std::size_t mode) {
    run.compute_angles();
    run_code(run.code_->values(mode), run.results_.data());
    const auto at = [&](TapeRef ref) -> const RunningError& { return run.at(ref); };
    const ModeProgram& program = run.code_->programs().programs[mode];
    const LinearMode<RunningError> solution(program, at);
    const auto compute = [&](const std::vector<SolvedForm>& forms, std::vector<LaneForm>& to) {
      to.resize(forms.size());
      for (std::size_t i = 0; i < forms.size(); ++i) {
        to[i] = lane_form(solution, forms[i], at,
                          [&](const RunningError& x) { return solution.divides() ? x / solution.divisor() : x; });
      }
    };
    compute(program.accelerations, run.values_.accelerations);
    compute(program.forces, run.values_.forces);
    compute(program.conditions, run.values_.conditions);
  }
};

ModeRun::ModeRun(const ModeCode& code)
    : code_(&code),
      results_(code.places()),
      tan_halves_(code.programs().angles),
      modes_(code.programs().programs.size()) {
  for (const auto& [place, value] : code.literals()) results_[place] = value;
  std::size_t conditions = 0;
  for (const ModeProgram& program : code.programs().programs) {
    conditions = std::max(conditions, program.conditions.size());
  }
  conditions_.resize(conditions);
}

void ModeRun::set(std::size_t input, std::size_t lane, double value, bool exact) {
  put_number(results_[input], lane, value, exact);
}

void ModeRun::set_angle(std::size_t angle, std::size_t lane, double tan_half, bool exact) {
  put_number(tan_halves_[angle], lane, tan_half, exact);
}

void ModeRun::compute_angles() {
  for (std::size_t i = 0; i < tan_halves_.size(); ++i) {
    const std::size_t place = code_->programs().cosine(i);
    const auto [cosine, sine] = circle_of(tan_halves_[i], RunningError{Lanes{} + 1, {}});
    results_[place] = cosine;
    results_[place + 1] = sine;
  }
}

void ModeRun::find_domain() {
  const ModePrograms& programs = code_->programs();
  in_domain_ = in_load_domain_ = all_lanes();
  for (const TapeRef divisor : programs.divisors) in_domain_ &= surely_not_zero(at(divisor));
  for (const TruthProgram& truth : programs.domain) in_domain_ &= holds(truth);
  for (const TruthProgram& truth : programs.loads) in_load_domain_ &= holds(truth);
}

void ModeRun::decide() {
  VectorKernel<JudgeKernel>::run(widest_registers(), *this);
}

LaneBits ModeRun::holds(const TruthProgram& program) const {
  return truth_of(program, all_lanes(),
                  [this](const TruthProgram::Step& step) {
                    return related_to_zero<LaneBits>(step.relation, at(step.difference), LaneSigns());
                  })
      .yes;
}

/// Judges a mode by its conditions, which must have been computed, at the points where the programs are valid.
LaneModes ModeRun::judge(const ModeProgram& program, const LaneBits& valid) const {
  LaneModes result;
  LaneBits violated{};
  for (const TapeRef residual : program.residuals) violated |= surely_not_zero(at(residual));
  for (std::size_t i = 0; i < program.conditions.size(); ++i) {
    if (!program.conditions[i].varies()) violated |= surely_negative(conditions_[i].constant);
  }
  if (program.free == 0) judge_determined(program, conditions_.data(), result);
  if (program.free == 1 || program.free == 2) judge_with_free(program, conditions_.data(), violated, result);
  const LaneBits sure = valid & ~violated & (program.residuals.empty() ? all_lanes() : LaneBits{});
  result.valid = valid;
  result.inconsistent = valid & violated;
  result.strict &= sure;
  result.boundary &= sure;
  return result;
}

std::optional<std::size_t> ModeRun::only_motion(std::size_t lane) const {
  const auto& programs = code_->programs().programs;
  const auto strict =
      std::find_if(modes_.begin(), modes_.end(), [&](const LaneModes& m) { return m.strict[lane] != 0; });
  if (strict == modes_.end()) return std::nullopt;
  const auto mode = static_cast<std::size_t>(strict - modes_.begin());
  if (!programs[mode].determined) return std::nullopt;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const LaneModes& m = modes_[i];
    if (programs[i].motion != programs[mode].motion) {
      if (m.inconsistent[lane] == 0) return std::nullopt;
      continue;
    }
    const LaneBits known = m.strict | m.boundary | m.inconsistent;
    if (m.valid[lane] == 0 || (known[lane] == 0 && !programs[i].never_strict)) return std::nullopt;
  }
  return mode;
}

const ModeRun::Values& ModeRun::compute_values(std::size_t mode) {
  VectorKernel<ValuesKernel>::run(widest_registers(), *this, mode);
  return values_;
}

void ModeRun::compute_scales() {
  VectorKernel<TapeKernel>::run(widest_registers(), code_->scales(), results_.data());
}

}  // namespace slipproof
