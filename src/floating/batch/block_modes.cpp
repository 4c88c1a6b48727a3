#include "floating/batch/block_modes.hpp"

#include <algorithm>
#include <cmath>

#include "floating/batch/block_kernel.hpp"
#include "floating/tape/linear_mode.hpp"
#include "floating/tape/truth.hpp"

namespace slipproof {

namespace {

struct RangeSigns {
  static std::uint64_t bits(bool sure) { return sure ? ~std::uint64_t{0} : 0; }
  std::uint64_t positive(const SharedRange& x) const { return bits(x.positive()); }
  std::uint64_t not_negative(const SharedRange& x) const { return bits(x.not_negative()); }
  std::uint64_t zero(const SharedRange& x) const { return bits(x.zero()); }
  std::uint64_t not_zero(const SharedRange& x) const { return bits(x.not_zero()); }
};

/// Whether a condition holds wherever the inputs are in their ranges; next() gives the differences of its steps.
template <class Next>
bool surely(const TruthProgram& truth, const Next& next) {
  return truth_of(truth, ~std::uint64_t{0}, [&](const TruthProgram::Step& step) {
           return related_to_zero<std::uint64_t>(step.relation, next(), RangeSigns());
         }).yes != 0;
}

/// The range of the values seen, widened to have room for points that follow.
SharedRange with_room(const SharedRange& seen) {
  constexpr double room = 8;
  return {seen.lower > 0 ? seen.lower / room : seen.lower * room,
          seen.upper > 0 ? seen.upper * room : seen.upper / room, 0};
}

double distance_from_zero(const SharedRange& x) {
  return std::max({0.0, x.lower, -x.upper});
}

/// Whether narrowing the range of a result to the values seen improves error bounds.
bool is_worth(const SharedRange& computed, const SharedRange& seen, bool divisor) {
  constexpr double gain = 4;
  return !(computed.size() <= gain * seen.size()) ||
         (divisor && distance_from_zero(seen) > gain * std::max(0.0, distance_from_zero(computed) - computed.error));
}

bool is_single(const TruthProgram& program) {
  return program.steps.size() == 1 && program.steps[0].operation == Operation::compare;
}

}  // namespace

BlockModes::BlockModes(const BlockCode& code)
    : code_(&code),
      inputs_(code.constant.size()),
      shared_(code.places),
      results_(code.divisors.size()),
      bounds_(code.modes.size()),
      pivots_(code.modes.size()) {
  constexpr std::size_t line = 8;
  memory_ = std::make_unique<double[]>(code.places * block_points + line);
  numbers_ = memory_.get();
  while (reinterpret_cast<std::uintptr_t>(numbers_) % 64 != 0) ++numbers_;
  for (const auto& [place, value] : code.literals) shared_[place] = value;
}

void BlockModes::set_ranges(std::span<const SharedRange> inputs) {
  std::copy(inputs.begin(), inputs.end(), inputs_.begin());
  std::copy(inputs.begin(), inputs.end(), shared_.begin());
  run_code(code_->of_constants, shared_.data());
  for (const std::uint32_t place : code_->constant_places) {
    std::fill_n(numbers_ + place * block_points, block_points, shared_[place].lower);
  }
  results_.assign(results_.size(), {});
}

void BlockModes::see_results() {
  VectorKernel<SeeResults>::run(widest_registers(), *this);
}

void BlockModes::find_bounds() {
  next_result_ = 0;
  run_narrowed(code_->domain);
  able_ = find_domain();
  for (std::size_t i = 0; able_ && i < code_->modes.size(); ++i) able_ = find_mode(i);
}

/// Runs code whose ranges were narrowed: checks at every point that each such result is in its range.
void BlockModes::run_narrowed(const TapeCode& code) {
  run_code(code, shared_.data(), [this](SharedRange& computed) {
    const bool divisor = code_->divisors[next_result_];
    ResultRange& result = results_[next_result_++];
    const SharedRange seen = with_room({result.lower, result.upper, 0});
    result.asked = seen.lower <= seen.upper && is_worth(computed, seen, divisor);
    if (!result.asked) return;
    computed.lower = result.lower = std::max(computed.lower, seen.lower);
    computed.upper = result.upper = std::min(computed.upper, seen.upper);
  });
}

bool BlockModes::add_check(std::uint32_t number, Check::Sign sign, std::vector<Check>& checks) const {
  const SharedRange& range = shared_[number];
  const bool holds = sign == Check::Sign::any        ? range.not_zero()
                     : sign == Check::Sign::positive ? range.positive()
                                                     : range.negative();
  if (!holds) checks.push_back({number, sign, range.error});
  return holds || range.known();
}

/// Prepares the checks of the domain; false if no point can be surely inside.
bool BlockModes::find_domain() {
  const ModePrograms& programs = *code_->programs;
  domain_.clear();
  auto place = code_->domain_numbers.begin();
  for (const auto* truths : {&programs.domain, &programs.loads}) {
    for (const TruthProgram& truth : *truths) {
      const auto first = place;
      if (surely(truth, [&]() -> const SharedRange& { return shared_[*place++]; })) continue;
      const Relation relation = truth.steps[0].relation;
      if (!is_single(truth) || relation == Relation::equal) return false;
      const bool negative = relation == Relation::less || relation == Relation::less_equal;
      const auto sign = relation == Relation::not_equal ? Check::Sign::any
                        : negative                      ? Check::Sign::negative
                                                        : Check::Sign::positive;
      if (!add_check(*first, sign, domain_)) return false;
    }
  }
  for (; place != code_->domain_numbers.end(); ++place) {
    if (!add_check(*place, Check::Sign::any, domain_)) return false;
  }
  return true;
}

/// Finds the error of a mode's divisor and the largest error of its conditions; false if one has no bound.
bool BlockModes::find_mode(std::size_t index) {
  const BlockMode& mode = code_->modes[index];
  run_narrowed(mode.code);
  const auto core = [&](const BlockForm& form) { return std::array{shared_[form.core[0]], shared_[form.core[1]]}; };
  const std::size_t unknowns = mode.equations.size();
  CoreSolution<SharedRange> solution;
  if (unknowns == 1) {
    solution = {core(mode.equations[0])[0], {-shared_[mode.equations[0].constant], {}}};
  } else if (unknowns == 2) {
    solution = solve_two(core(mode.equations[0]), shared_[mode.equations[0].constant], core(mode.equations[1]),
                         shared_[mode.equations[1].constant]);
  }
  Bounds& bounds = bounds_[index] = {solution.divisor.error, 0};
  bool known = solution.divisor.known();
  for (const BlockForm& form : mode.conditions) {
    const SharedRange& constant = shared_[form.constant];
    const SharedRange value = unknowns == 0 ? constant : on_core(unknowns, constant, core(form), solution);
    bounds.conditions = std::max(bounds.conditions, value.error);
    known = known && value.known();
  }
  pivots_[index].clear();
  for (const std::uint32_t pivot : mode.pivots) {
    known = known && add_check(pivot, Check::Sign::any, pivots_[index]);
  }
  return known;
}

void BlockModes::decide(BlockAnswers& answers) {
  answers.inconsistent.resize((code_->modes.size() + 63) / 64);
  for (auto& word : answers.inconsistent) word.fill(0);
  if (!able_) {
    answers.left.fill(-1);
    return;
  }
  VectorKernel<DecideModes>::run(widest_registers(), *this, answers);
}

}  // namespace slipproof
