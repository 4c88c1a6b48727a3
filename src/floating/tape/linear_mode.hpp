// Solves the core of a mode and evaluates forms on the solution, over any number type.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "floating/tape/mode_programs.hpp"

namespace slipproof {

/// The determinant and Cramer's numerators for the equations of a core with no, one or two unknowns.
template <class N>
struct CoreSolution {
  N divisor{};
  std::array<N, 2> values{};
};

/// Solves x . (u, v) + r = 0 and y . (u, v) + s = 0.
template <class N>
CoreSolution<N> solve_two(const std::array<N, 2>& x, const N& r, const std::array<N, 2>& y, const N& s) {
  return {x[0] * y[1] - x[1] * y[0], {x[1] * s - r * y[1], r * y[0] - x[0] * s}};
}

/// A form of one or two unknowns, times the divisor.
template <class N>
N on_core(std::size_t unknowns, const N& constant, const std::array<N, 2>& core, const CoreSolution<N>& solution) {
  const N sum = constant * solution.divisor + core[0] * solution.values[0];
  return unknowns == 1 ? sum : sum + core[1] * solution.values[1];
}

/// The forms of a mode at one point, or at several points side by side. `at(ref)` gives a result of the tape. If more
/// than two numbers are free, only the first two are used.
template <class N>
class LinearMode {
 public:
  static constexpr std::size_t most_free = 2;

  template <class At>
  LinearMode(const ModeProgram& program, const At& at) : unknowns_(program.core.size()) {
    constant_ = solved(program, at, [](const SolvedForm& equation) { return equation.constant; });
    for (std::size_t k = 0; k < std::min(program.free, most_free); ++k) {
      slopes_[k] = solved(program, at, [k](const SolvedForm& equation) { return equation.free[k]; });
    }
  }

  /// Whether there is a divisor; if so, all numbers below are multiplied by it.
  bool divides() const { return unknowns_ > 0; }
  const N& divisor() const { return constant_.divisor; }

  template <class At>
  N constant(const SolvedForm& form, const At& at) const {
    return form.no_constant ? N{} : on(form, at, form.constant, constant_);
  }
  template <class At>
  N slope(const SolvedForm& form, std::size_t k, const At& at) const {
    return form.no_slope[k] ? N{} : on(form, at, form.free[k], slopes_[k]);
  }

 private:
  template <class At, class Side>
  CoreSolution<N> solved(const ModeProgram& program, const At& at, const Side& side) const {
    if (unknowns_ == 0) return {};
    const SolvedForm &x = program.core.front(), &y = program.core.back();
    if (unknowns_ == 1) return {at(x.core[0]), {-at(side(x)), N{}}};
    return solve_two<N>({at(x.core[0]), at(x.core[1])}, at(side(x)), {at(y.core[0]), at(y.core[1])}, at(side(y)));
  }

  template <class At>
  N on(const SolvedForm& form, const At& at, TapeRef own, const CoreSolution<N>& solution) const {
    if (unknowns_ == 0) return at(own);
    return on_core<N>(unknowns_, at(own), {at(form.core.front()), at(form.core.back())}, solution);
  }

  std::size_t unknowns_;
  CoreSolution<N> constant_;
  std::array<CoreSolution<N>, most_free> slopes_;
};

}  // namespace slipproof
