#include "floating/tape/mode_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/number/binary64.hpp"
#include "floating/filter/vector_kernel.hpp"

namespace slipproof {

namespace {

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

LaneBits all_lanes() {
  return ~LaneBits{};
}

/// Of a number that is the nearest binary64 to what is meant; nothing is known of one that is not finite.
double rounding_error(double value) {
  return std::fabs(value) * batch_rounding + batch_underflow;
}

void put(RunningError& number, std::size_t lane, double value, bool exact) {
  number.value[lane] = value;
  number.error[lane] = exact && std::isfinite(value) ? 0 : rounding_error(value);
}

RunningError rounded(const Rational& value) {
  const double nearest = nearest_binary64(value);
  if (!std::isfinite(nearest)) return {Lanes{}, Lanes{} + HUGE_VAL};
  return {Lanes{} + nearest, Lanes{} + (to_rational(nearest) == value ? 0 : rounding_error(nearest))};
}

/// The lanes are as many as the widest registers hold; the compiler splits them up for narrower ones.
struct RunTape {
  template <int width>
  static void run(std::span<const TapeInstruction> code, RunningError* results) {
    for (const TapeInstruction& step : code) {
      const RunningError &x = results[step.first], &y = results[step.second];
      RunningError& result = results[step.target];
      switch (step.operation) {
        case TapeOperation::add:
          result = x + y;
          break;
        case TapeOperation::subtract:
          result = x - y;
          break;
        case TapeOperation::multiply:
          result = x * y;
          break;
        case TapeOperation::divide:
          result = x / y;
          break;
        default:
          result = -x;
      }
    }
  }
};

void run_tape(std::span<const TapeInstruction> code, RunningError* results) {
  VectorKernel<RunTape>::run(widest_registers(), code, results);
}

void add_form(std::vector<TapeRef>& wanted, const FreeForm& form) {
  wanted.push_back(form.constant);
  wanted.insert(wanted.end(), form.slopes.begin(), form.slopes.end());
}

void add_truths(std::vector<TapeRef>& wanted, const std::vector<TruthProgram>& truths) {
  for (const TruthProgram& truth : truths) {
    for (const auto& step : truth.steps) {
      if (step.operation == Operation::compare) wanted.push_back(step.difference);
    }
  }
}

/// What the decisions ask for.
std::vector<TapeRef> decision_of(const ModePrograms& programs) {
  std::vector<TapeRef> wanted = programs.divisors;
  add_truths(wanted, programs.domain);
  add_truths(wanted, programs.loads);
  for (const ModeProgram& program : programs.programs) {
    wanted.insert(wanted.end(), program.pivots.begin(), program.pivots.end());
    wanted.insert(wanted.end(), program.residuals.begin(), program.residuals.end());
    for (const FreeForm& form : program.conditions) add_form(wanted, form);
  }
  return wanted;
}

struct YesNo {
  LaneBits yes, no;
};

YesNo compared(Relation relation, const RunningError& d) {
  switch (relation) {
    case Relation::less:
      return {surely_negative(d), surely_not_negative(d)};
    case Relation::less_equal:
      return {surely_not_negative(-d), surely_positive(d)};
    case Relation::greater:
      return {surely_positive(d), surely_not_negative(-d)};
    case Relation::greater_equal:
      return {surely_not_negative(d), surely_negative(d)};
    case Relation::equal:
      return {surely_zero(d), surely_not_zero(d)};
    default:
      return {surely_not_zero(d), surely_zero(d)};
  }
}

/// The sure ends of where conditions alpha + beta t >= 0 hold, and those that are likely.
struct FreeInterval {
  Lanes lower = Lanes{} - HUGE_VAL, upper = Lanes{} + HUGE_VAL;     ///< likely
  Lanes lowest = Lanes{} - HUGE_VAL, highest = Lanes{} + HUGE_VAL;  ///< no t outside

  void cut(const RunningError& root, const LaneBits& from_below, const LaneBits& from_above) {
    const Lanes margin = (root.error + batch_rounding * absolute(root.value)) * batch_slack;
    const Lanes low = root.value - margin, high = root.value + margin;
    lower = chosen(from_below & (root.value > lower), root.value, lower);
    lowest = chosen(from_below & (low > lowest), low, lowest);
    upper = chosen(from_above & (root.value < upper), root.value, upper);
    highest = chosen(from_above & (high < highest), high, highest);
  }

  /// Somewhere inside, if anything is.
  Lanes inside() const {
    const LaneBits has_lower = lower > -HUGE_VAL, has_upper = upper < HUGE_VAL;
    const Lanes above = lower + absolute(lower) + 1, below = upper - absolute(upper) - 1;
    const Lanes one_end = chosen(has_lower, above, chosen(has_upper, below, Lanes{}));
    return chosen(has_lower & has_upper, lower * 0.5 + upper * 0.5, one_end);
  }
};

/// constant + slopes . t >= 0, at the points where that is so.
struct HalfSpace {
  RunningError constant;
  std::array<RunningError, 2> slopes;
  LaneBits asked;
};

FreeInterval interval_of(const std::vector<HalfSpace>& sides, std::size_t k) {
  FreeInterval interval;
  for (const HalfSpace& side : sides) {
    const RunningError& slope = side.slopes[k];
    interval.cut(-side.constant / slope, side.asked & surely_positive(slope), side.asked & surely_negative(slope));
  }
  return interval;
}

/// What follows for the second of two free numbers, after Fourier and Motzkin: all of it where the signs of the slopes
/// are sure, and nothing else in any case.
std::vector<HalfSpace> without_first(const std::vector<HalfSpace>& sides) {
  std::vector<HalfSpace> result;
  for (const HalfSpace& x : sides) {
    result.push_back({x.constant, {RunningError{}, x.slopes[1]}, surely_zero(x.slopes[0])});
    for (const HalfSpace& y : sides) {
      const LaneBits opposite = surely_positive(x.slopes[0]) & surely_negative(y.slopes[0]);
      result.push_back({x.slopes[0] * y.constant - y.slopes[0] * x.constant,
                        {RunningError{}, x.slopes[0] * y.slopes[1] - y.slopes[0] * x.slopes[1]},
                        opposite});
    }
  }
  return result;
}

}  // namespace

ModeCode::ModeCode(ModePrograms programs) : programs_(std::move(programs)), places_(programs_.nodes.size(), nowhere) {
  std::vector<bool> done(programs_.nodes.size(), false);
  for (std::size_t i = 0; i < programs_.nodes.size(); ++i) {
    const TapeNode& node = programs_.nodes[i];
    if (node.operation == TapeOperation::input) places_[i] = node.first;
    done[i] = node.operation == TapeOperation::input;
  }
  results_ = static_cast<std::uint32_t>(programs_.inputs());
  decision_ = code_for(decision_of(programs_), done);
  const auto beyond = [&](const std::vector<TapeRef>& wanted) {
    std::vector<bool> known = done;  // no other mode's numbers may have been computed
    return code_for(wanted, known);
  };
  std::vector<TapeRef> scales = programs_.line_constants;
  for (const auto* divisors : {&programs_.inertias, &programs_.levers}) {
    for (const auto& refs : *divisors) scales.insert(scales.end(), refs.begin(), refs.end());
  }
  scales_ = beyond(scales);
  for (const ModeProgram& program : programs_.programs) {
    std::vector<TapeRef> wanted;
    for (const FreeForm& form : program.accelerations) add_form(wanted, form);
    for (const FreeForm& form : program.forces) add_form(wanted, form);
    values_.push_back(beyond(wanted));
  }
}

std::uint32_t ModeCode::place(TapeRef ref) {
  if (places_[ref] == nowhere) {
    places_[ref] = results_++;
    const TapeNode& node = programs_.nodes[ref];
    if (node.operation == TapeOperation::constant) {
      constants_.emplace_back(places_[ref], rounded(programs_.constants[node.first]));
    }
  }
  return places_[ref];
}

ModeCode::Code ModeCode::code_for(const std::vector<TapeRef>& wanted, std::vector<bool>& done) {
  std::vector<bool> needed(programs_.nodes.size(), false);
  for (const TapeRef ref : wanted) needed[ref] = true;
  for (std::size_t i = needed.size(); i-- > 0;) {
    const TapeNode& node = programs_.nodes[i];
    if (!needed[i] || done[i] || node.operation == TapeOperation::constant) continue;
    needed[node.first] = true;
    needed[node.second] = true;  // of a negation the literal 0
  }
  Code code;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    const auto ref = static_cast<TapeRef>(i);
    const TapeNode& node = programs_.nodes[i];
    if (!needed[i] || done[i]) continue;
    done[i] = true;
    const std::uint32_t target = place(ref);
    if (node.operation == TapeOperation::constant) continue;
    code.push_back({node.operation, target, place(node.first), place(node.second)});
  }
  return code;
}

ModeRun::ModeRun(const ModeCode& code)
    : code_(&code),
      results_(code.results_),
      tan_halves_(code.programs().angles),
      modes_(code.programs().programs.size()) {
  for (const auto& [place, value] : code.constants_) results_[place] = value;
}

void ModeRun::set(std::size_t input, std::size_t lane, double value, bool exact) {
  put(results_[input], lane, value, exact);
}

void ModeRun::set_angle(std::size_t angle, std::size_t lane, double tan_half, bool exact) {
  put(tan_halves_[angle], lane, tan_half, exact);
}

void ModeRun::compute_angles() {
  const RunningError one{Lanes{} + 1, {}};
  for (std::size_t i = 0; i < tan_halves_.size(); ++i) {
    const RunningError& t = tan_halves_[i];
    const RunningError square = t * t;
    const std::size_t place = code_->programs().cosine(i);
    results_[place] = (one - square) / (one + square);
    results_[place + 1] = (t + t) / (one + square);
  }
}

void ModeRun::decide() {
  const ModePrograms& programs = code_->programs();
  compute_angles();
  run_tape(code_->decision_, results_.data());
  in_domain_ = in_load_domain_ = all_lanes();
  for (const TapeRef divisor : programs.divisors) in_domain_ &= surely_not_zero(at(divisor));
  for (const TruthProgram& truth : programs.domain) in_domain_ &= holds(truth);
  for (const TruthProgram& truth : programs.loads) in_load_domain_ &= holds(truth);
  for (std::size_t i = 0; i < modes_.size(); ++i) modes_[i] = judge(programs.programs[i]);
}

LaneBits ModeRun::holds(const TruthProgram& program) const {
  std::vector<YesNo> found;
  for (const auto& step : program.steps) {
    switch (step.operation) {
      case Operation::truth:
        found.push_back(step.truth ? YesNo{all_lanes(), {}} : YesNo{{}, all_lanes()});
        break;
      case Operation::logical_not:
        found.push_back({found[step.first].no, found[step.first].yes});
        break;
      case Operation::logical_and:
        found.push_back({found[step.first].yes & found[step.second].yes, found[step.first].no | found[step.second].no});
        break;
      case Operation::logical_or:
        found.push_back({found[step.first].yes | found[step.second].yes, found[step.first].no & found[step.second].no});
        break;
      default:
        found.push_back(compared(step.relation, at(step.difference)));
    }
  }
  return found.back().yes;
}

RunningError ModeRun::at(const FreeForm& form, std::span<const RunningError> free) const {
  RunningError value = at(form.constant);
  for (std::size_t k = 0; k < form.slopes.size(); ++k) {
    if (form.slopes[k] != TapeBuilder::zero) value = value + at(form.slopes[k]) * free[k];
  }
  return value;
}

LaneModes ModeRun::judge(const ModeProgram& program) const {
  LaneModes result;
  result.valid = in_domain_;
  for (const TapeRef pivot : program.pivots) result.valid &= surely_not_zero(at(pivot));
  LaneBits violated{};
  for (const TapeRef residual : program.residuals) violated |= surely_not_zero(at(residual));
  for (const FreeForm& form : program.conditions) {
    if (!form.varies()) violated |= surely_negative(at(form.constant));
  }
  if (program.free == 0) judge_determined(program, violated, result);
  if (program.free == 1 || program.free == 2) judge_with_free(program, violated, result);
  const LaneBits sure = result.valid & ~violated & (program.residuals.empty() ? all_lanes() : LaneBits{});
  result.inconsistent = result.valid & violated;
  result.strict &= sure;
  result.boundary &= sure;
  return result;
}

void ModeRun::judge_determined(const ModeProgram& program, LaneBits& violated, LaneModes& result) const {
  LaneBits holds = all_lanes(), zero{}, strict = program.never_strict ? LaneBits{} : all_lanes();
  for (const FreeForm& form : program.conditions) {
    const RunningError& value = at(form.constant);
    const LaneBits positive = surely_positive(value), vanishes = surely_zero(value);
    strict &= positive;
    zero |= vanishes;
    holds &= positive | vanishes;
  }
  result.strict = strict;
  result.boundary = holds & (program.never_strict ? all_lanes() : zero) & ~violated;
}

void ModeRun::judge_with_free(const ModeProgram& program, LaneBits& violated, LaneModes& result) const {
  std::vector<HalfSpace> sides;
  for (const FreeForm& form : program.conditions) {
    if (!form.varies()) continue;
    HalfSpace side{at(form.constant), {}, all_lanes()};
    for (std::size_t k = 0; k < program.free; ++k) side.slopes[k] = at(form.slopes[k]);
    sides.push_back(side);
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
  for (const FreeForm& form : program.conditions) holds &= surely_positive(at(form, inside));
  result.strict = program.never_strict ? LaneBits{} : holds;
  result.boundary = program.never_strict ? holds : LaneBits{};
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

void ModeRun::compute_values(std::size_t mode) {
  const auto& code = code_->values_[mode];
  run_tape(code, results_.data());
}

void ModeRun::compute_scales() {
  run_tape(code_->scales_, results_.data());
}

}  // namespace slipproof
