// Excludes modes without a solution in binary64 with error bounds: nearly all modes of a mechanism are of this kind,
// and their exact elimination would be most of the work.
//
// Eliminates the equations of a mode with pivots that are surely not 0. If this fixes every unknown, each condition
// bounds the load, alpha + beta load >= 0. The mode is excluded if a condition is surely negative for all loads, or if
// a lower bound of the load is surely above an upper one. Nothing unsure excludes a mode.
#pragma once

#include <optional>
#include <vector>

#include "base/rounding/approximate.hpp"
#include "mechanics/elements/state_rows.hpp"

namespace slipproof {

class ModeFilter {
 public:
  /// A filter at a load, or for the whole domain, of modes with these states.
  ModeFilter(const FrictionProblem& problem, const std::optional<Rational>& load, const ForceInterval& domain,
             const StatesOfElements& states);

  /// Whether the mode surely has no solution.
  bool excludes(const MechanismMode& mode) const;

 private:
  using Row = std::vector<Approximate>;  ///< coefficients of the unknowns and of the load, and the constant
  struct StateRows {
    std::vector<Row> equations, conditions;
  };
  class Elimination;

  Row row_of(const AffineForm& form) const;

  std::size_t unknowns_;
  std::optional<Approximate> load_;             ///< the one there is
  std::vector<Row> equations_;                  ///< common to all modes
  std::vector<std::vector<StateRows>> states_;  ///< by element and state
  std::vector<Approximate> above_, below_;      ///< ends of the domain
};

}  // namespace slipproof
