// A mechanism along a line of its setting, and where the motions of a mode change there.
//
// Along a line the coefficients of the mechanism are rational functions of t, and those of the equations of a mode,
// brought to polynomials, are eliminated without fractions. Where a pivot, or a factor that is divided out, vanishes
// the elimination is another one: these t are critical. Between them, what the mode's conditions are and where they
// vanish follows from the eliminated rows. Forces that stay undetermined are eliminated from the conditions, pair by
// pair, after Fourier and Motzkin: the loads with a solution end where one of the forms that are left vanishes.
#pragma once

#include <optional>
#include <vector>

#include "claims/lines/critical_set.hpp"
#include "claims/paper/compiled.hpp"
#include "mechanics/mechanism/system.hpp"

namespace slipproof {

using LineEvaluator = Evaluator<LineFunction, LineField>;

/// Over the unknowns, the force variable and 1.
using PolynomialRow = std::vector<IntegerPolynomial>;

class LineMechanism {
 public:
  /// `paper` has the values of the setting's parameters along the line. What the coefficients divide by is found there.
  LineMechanism(const CompiledSetting& setting, LineEvaluator& paper);

  /// False where some coefficient has no value all along the line: then there are no motions.
  bool has_value() const { return system_.has_value(); }
  /// Adds to `found` what is critical for a mode. Gives the wanted slots, of quantities, their values in `paper` where
  /// the force determines them; false where the mode has no solution all along the line, or is not looked into because
  /// eliminating undetermined forces takes too many forms.
  bool add_mode(const MechanismMode& mode, const std::vector<std::size_t>& wanted, CriticalSet& found,
                LineEvaluator& paper) const;

  /// The equations of a mode, each multiplied by a polynomial that is added to `found`.
  std::vector<PolynomialRow> equations(const MechanismMode& mode, CriticalSet& found) const;

 private:
  const CompiledSetting& setting_;
  std::optional<MechanismSystem<LineFunction>> system_;
  LineFunction load_ = LineFunction::force();  ///< over the force variable
};

}  // namespace slipproof
