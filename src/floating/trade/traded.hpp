// The mechanism on which number types are compared, compiled, with the exact answers about it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "floating/batch/mechanism_batch.hpp"
#include "floating/tape/mode_code.hpp"

namespace slipproof {

/// The inputs of the tape: a number for each parameter, 0 if it is not given, then the load.
using TradeScene = std::vector<Rational>;

/// The quantities whose errors are measured: the acceleration, then the forces.
inline constexpr std::array judged_quantities{"a", "S2", "S3", "N2", "N3"};
template <class T>
using JudgedValues = std::array<T, judged_quantities.size()>;

struct ExactAnswer {
  std::vector<ModeAt> status;       ///< of each mode
  std::optional<std::size_t> only;  ///< the mode, if exactly one is consistent and it has one solution; then also:
  JudgedValues<Rational> values;    ///< of its motion
  /// For numerator and denominator of each value: the sum of |monomials| over |sum of monomials|. It bounds how much
  /// roundings of inputs and operations are magnified. Infinite for a value that is 0. Nothing if the program divides
  /// by 0, or if condition numbers were not asked for.
  std::optional<JudgedValues<double>> conditions;
};

/// Immutable; may be used by several threads.
class TradedMechanism {
 public:
  /// The shipped bicycle, whose wheels may leave the road if `lifts`. No mode leaves a number free.
  explicit TradedMechanism(bool lifts);
  static const TradedMechanism& get(bool lifts);

  const MechanismBatch& batch() const { return batch_; }
  const ModeCode& code() const { return *batch_.code(); }
  std::size_t modes() const { return batch_.modes().size(); }
  /// Selects a judged quantity from all accelerations and forces of a problem, a program or a run.
  template <class List>
  const auto& judged(std::size_t i, const List& all) const {
    return i == 0 ? all.accelerations[places_[i]] : all.forces[places_[i]];
  }

  /// The exact answer of the kernel.
  ExactAnswer exact(const TradeScene& scene) const;
  /// The same with the condition numbers.
  ExactAnswer exact_with_conditions(const TradeScene& scene) const;
  /// Loads other than 0 at which some mode begins or ceases to have a solution, in the order of the modes.
  std::vector<Rational> thresholds(const TradeScene& scene) const;

 private:
  FrictionProblem problem(const TradeScene& scene) const;

  ProblemMaker maker_;
  MechanismBatch batch_;
  JudgedValues<std::size_t> places_{};
};

}  // namespace slipproof
