#include "floating/trade/traded.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "floating/trade/tape_run.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/scene/bicycle_scene.hpp"

namespace slipproof {

namespace {

/// A result of the tape, and its magnitude if all signs of sums were positive.
struct Conditioned {
  Rational value, size;

  friend Conditioned operator-(const Conditioned& x) { return {-x.value, x.size}; }
  friend Conditioned operator+(const Conditioned& x, const Conditioned& y) {
    return {x.value + y.value, x.size + y.size};
  }
  friend Conditioned operator-(const Conditioned& x, const Conditioned& y) { return x + -y; }
  friend Conditioned operator*(const Conditioned& x, const Conditioned& y) {
    return {x.value * y.value, x.size * y.size};
  }
  friend Conditioned operator/(const Conditioned& x, const Conditioned& y) {
    return {x.value / y.value, x.size * y.size / (y.value * y.value)};
  }
  Rational condition() const { return size / abs(value); }
};

Conditioned conditioned(const Rational& x) {
  return {x, abs(x)};
}

std::vector<bool> given_parameters(bool lifts) {
  std::vector<bool> given(bicycle_mechanism().parameters.size(), true);
  given[bicycle_parameter("J")] = lifts;
  return given;
}

}  // namespace

TradedMechanism::TradedMechanism(bool lifts)
    : maker_(bicycle_mechanism()), batch_(bicycle_mechanism(), starts(bicycle_mechanism()), given_parameters(lifts)) {
  const auto accelerations = acceleration_names(bicycle_mechanism()), forces = force_names(bicycle_mechanism());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto& names = i == 0 ? accelerations : forces;
    places_[i] = static_cast<std::size_t>(std::ranges::find(names, judged_quantities[i]) - names.begin());
  }
}

const TradedMechanism& TradedMechanism::get(bool lifts) {
  if (lifts) {
    static const TradedMechanism lifting(true);
    return lifting;
  }
  static const TradedMechanism on_road(false);
  return on_road;
}

FrictionProblem TradedMechanism::problem(const TradeScene& scene) const {
  MechanismValues values = default_values(bicycle_mechanism());
  values.given = batch_.given();
  std::copy_n(scene.begin(), values.parameters.size(), values.parameters.begin());
  return without_equations(maker_.problem(values));
}

ExactAnswer TradedMechanism::exact(const TradeScene& scene) const {
  const FrictionProblem problem = this->problem(scene);
  const std::vector<ConsistentMode> found = ModeSolver(problem, scene.back()).consistent();
  ExactAnswer answer{std::vector<ModeAt>(modes(), ModeAt::inconsistent), {}, {}, {}};
  std::size_t index = 0;
  for (const ConsistentMode& mode : found) {
    index = static_cast<std::size_t>(std::ranges::find(batch_.modes(), mode.mode) - batch_.modes().begin());
    answer.status[index] = mode.solutions.strict ? ModeAt::strict : ModeAt::boundary;
  }
  if (found.size() != 1 || found[0].solutions.space.dimension() > 0) return answer;
  answer.only = index;
  for (std::size_t i = 0; i < answer.values.size(); ++i) {
    answer.values[i] = found[0].solutions.space.on(judged(i, problem)).constant;
  }
  return answer;
}

ExactAnswer TradedMechanism::exact_with_conditions(const TradeScene& scene) const {
  ExactAnswer answer = exact(scene);
  if (!answer.only) return answer;
  TapeRun<Conditioned> run(code(), conditioned);
  std::vector<Conditioned> inputs;
  std::ranges::transform(scene, std::back_inserter(inputs), conditioned);
  run.decide(inputs);
  run.compute_values(*answer.only);
  const LinearMode<Conditioned> solution = run.solution(*answer.only);
  if (solution.divisor().value.is_zero()) return answer;
  answer.conditions.emplace();
  for (std::size_t i = 0; i < answer.values.size(); ++i) {
    const Conditioned numerator = run.on(solution, judged(i, run.program(*answer.only)));
    (*answer.conditions)[i] =
        numerator.value.is_zero() ? HUGE_VAL : nearest_binary64(numerator.condition() + solution.divisor().condition());
  }
  return answer;
}

std::vector<Rational> TradedMechanism::thresholds(const TradeScene& scene) const {
  const FrictionProblem problem = this->problem(scene);
  std::vector<Rational> ends;
  for (const ConsistentMode& mode : ModeSolver(problem, std::nullopt).consistent()) {
    for (const auto& end : {mode.solutions.loads.lower(), mode.solutions.loads.upper()}) {
      if (end && !end->is_zero()) ends.push_back(*end);
    }
  }
  return ends;
}

}  // namespace slipproof
