// A mechanism along a line of its setting, and where the motions of a mode change there.
//
// Along a line the coefficients of the mechanism are rational functions of t, and those of the equations of a mode,
// brought to polynomials, are eliminated without fractions: first those that all modes share, then those of a mode's
// states. Where a pivot, or a factor that is divided out, vanishes
// the elimination is another one: these t are critical. Between them, what the mode's conditions are and where they
// vanish follows from the eliminated rows. Forces that stay undetermined are eliminated from the conditions, pair by
// pair, after Fourier and Motzkin: the loads with a solution end where one of the forms that are left vanishes.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "claims/lines/critical_set.hpp"
#include "claims/lines/polynomial_rows.hpp"
#include "claims/paper/compiled.hpp"
#include "mechanics/mechanism/system.hpp"

namespace slipproof {

using LineEvaluator = Evaluator<LineFunction, LineField>;

class LineMechanism {
 public:
  /// `paper` has the values of the setting's parameters along the line; what is critical is added to its field's set.
  /// Both must outlive it.
  LineMechanism(const CompiledSetting& setting, LineEvaluator& paper);

  /// False where some coefficient has no value all along the line: then there are no motions.
  bool has_value() const { return system_.has_value(); }
  /// Adds what is critical for a mode. Gives the wanted slots, of quantities, their values in `paper` where the force
  /// determines them; false where the mode has no solution all along the line, or is not looked into because
  /// eliminating undetermined forces takes too many forms.
  bool add_mode(const MechanismMode& mode, const std::vector<std::size_t>& wanted);

  /// The equations of a mode, each multiplied by a polynomial that is critical.
  std::vector<PolynomialRow> equations(const MechanismMode& mode) const;

  /// A form in polynomials.
  struct ScaledRow {
    PolynomialRow row;
    IntegerPolynomial factor;  ///< by which the form is multiplied
  };

 private:
  /// What a state of an element asks for, over the unknowns that the mechanism's own equations leave open.
  struct StateRows {
    std::vector<PolynomialRow> equations, conditions;
  };
  /// The mechanism's own equations, which all modes share, solved.
  const SolvedRows& in_every_mode();
  ScaledRow reduced(const FormRow<LineFunction>& form);
  const StateRows& rows_of(std::size_t element, ElementState state);

  const CompiledSetting& setting_;
  LineEvaluator& paper_;
  CriticalSet& found_;
  std::optional<MechanismSystem<LineFunction>> system_;
  LineFunction load_ = LineFunction::force();  ///< over the force variable
  std::optional<SolvedRows> in_every_mode_;
  std::vector<std::map<ElementState, StateRows>> rows_;  ///< by element; made when a mode has the state
};

}  // namespace slipproof
