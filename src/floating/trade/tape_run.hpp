// Runs a mechanism's program in one number type, for one scene after another.
#pragma once

#include <algorithm>
#include <vector>

#include "floating/tape/linear_mode.hpp"
#include "floating/tape/mode_code.hpp"

namespace slipproof {

/// N has the operations of run_code(). It may hold the numbers of several scenes side by side.
template <class N>
class TapeRun {
 public:
  /// `number(x)` converts a rational to N. The code must outlive the run.
  template <class Number>
  TapeRun(const ModeCode& code, const Number& number) : code_(&code), numbers_(code.places()) {
    const std::vector<TapeNode>& nodes = code.programs().nodes;
    for (TapeRef i = 0; i < nodes.size(); ++i) {
      if (nodes[i].operation != TapeOperation::constant || code.place(i) >= code.places()) continue;
      numbers_[code.place(i)] = number(code.programs().constants[nodes[i].first]);
    }
  }

  void decide(const std::vector<N>& inputs) {
    std::copy(inputs.begin(), inputs.end(), numbers_.begin());
    run_code(code_->decision(), numbers_.data());
  }
  /// After decide(): computes the remaining numbers of the motion in a mode.
  void compute_values(std::size_t mode) { run_code(code_->values(mode), numbers_.data()); }

  const N& at(TapeRef ref) const { return numbers_[code_->place(ref)]; }
  const ModeProgram& program(std::size_t mode) const { return code_->programs().programs[mode]; }
  LinearMode<N> solution(std::size_t mode) const { return {program(mode), reader()}; }
  /// A form on the solution, times the divisor.
  N on(const LinearMode<N>& solution, const SolvedForm& form) const { return solution.constant(form, reader()); }

 private:
  auto reader() const {
    return [this](TapeRef ref) -> const N& { return at(ref); };
  }

  const ModeCode* code_;
  std::vector<N> numbers_;
};

}  // namespace slipproof
