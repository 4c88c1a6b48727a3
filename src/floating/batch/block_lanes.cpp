#include "floating/batch/block_lanes.hpp"

#include "floating/lanes/vector_kernel.hpp"
#include "floating/tape/linear_mode.hpp"

namespace slipproof {

BlockLanes::BlockLanes(const BlockCode& code)
    : code_(&code), numbers_(code.places), tan_halves_(code.programs->angles), modes_(code.modes.size()) {
  for (const auto& [place, literal] : code.literals) {
    numbers_[place] = {Lanes{} + literal.lower, Lanes{} + literal.error};
  }
}

void BlockLanes::set(std::size_t input, std::size_t lane, double value, bool exact) {
  put_number(numbers_[input], lane, value, exact);
}

void BlockLanes::set_angle(std::size_t angle, std::size_t lane, double tan_half, bool exact) {
  put_number(tan_halves_[angle], lane, tan_half, exact);
}

void BlockLanes::find_domain() {
  const ModePrograms& programs = *code_->programs;
  in_domain_ = ~LaneBits{};
  auto place = code_->domain_numbers.begin();
  for (const auto* truths : {&programs.domain, &programs.loads}) {
    for (const TruthProgram& truth : *truths) {
      in_domain_ &= truth_of(truth, LaneBits(~LaneBits{}), [&](const TruthProgram::Step& step) {
                      return related_to_zero<LaneBits>(step.relation, numbers_[*place++], LaneSigns());
                    }).yes;
    }
  }
  for (; place != code_->domain_numbers.end(); ++place) in_domain_ &= surely_not_zero(numbers_[*place]);
}

/// As the kernel of blocks does.
SureModes BlockLanes::judge(const BlockMode& mode) const {
  const auto core = [&](const BlockForm& form) { return std::array{numbers_[form.core[0]], numbers_[form.core[1]]}; };
  const std::size_t unknowns = mode.equations.size();
  CoreSolution<RunningError> solution;
  if (unknowns == 1) {
    solution = {core(mode.equations[0])[0], {-numbers_[mode.equations[0].constant], {}}};
  } else if (unknowns == 2) {
    solution = solve_two(core(mode.equations[0]), numbers_[mode.equations[0].constant], core(mode.equations[1]),
                         numbers_[mode.equations[1].constant]);
  }
  LaneBits valid = in_domain_, orientation{}, violated{}, holds = ~LaneBits{};
  if (unknowns > 0) {
    valid &= surely_not_zero(solution.divisor);
    orientation = bits(solution.divisor.value) & sign_bit<Lanes>();
  }
  for (const std::uint32_t pivot : mode.pivots) valid &= surely_not_zero(numbers_[pivot]);
  for (const BlockForm& form : mode.conditions) {
    const RunningError& constant = numbers_[form.constant];
    RunningError value = unknowns == 0 ? constant : on_core(unknowns, constant, core(form), solution);
    value.value = from_bits(LaneBits(bits(value.value) ^ orientation));
    violated |= surely_negative(value);
    holds &= surely_positive(value);
  }
  return {valid & violated, mode.only_refuted ? LaneBits{} : valid & holds};
}

struct BlockLanesKernel {
  template <int width>
  static void run(BlockLanes& lanes) {
    const BlockCode& code = *lanes.code_;
    for (std::size_t i = 0; i < lanes.tan_halves_.size(); ++i) {
      const auto [cosine, sine] = circle_of(lanes.tan_halves_[i], RunningError{Lanes{} + 1, {}});
      lanes.numbers_[code.programs->cosine(i)] = cosine;
      lanes.numbers_[code.programs->cosine(i) + 1] = sine;
    }
    run_code(code.of_constants, lanes.numbers_.data());
    run_code(code.domain, lanes.numbers_.data());
    lanes.find_domain();
    for (std::size_t i = 0; i < code.modes.size(); ++i) {
      run_code(code.modes[i].code, lanes.numbers_.data());
      lanes.modes_[i] = lanes.judge(code.modes[i]);
    }
  }
};

void BlockLanes::decide() {
  VectorKernel<BlockLanesKernel>::run(widest_registers(), *this);
}

}  // namespace slipproof
