// A mechanism along a line of its family, and the places where the motions in a mode change.
//
// Along a line the coefficients of the mechanism are rational functions of t. The equations of a mode, multiplied to
// become polynomials, are eliminated without fractions: first those that all modes share, then those of the mode's
// states. Where a pivot or a factor that is divided out vanishes, the elimination differs; these t are critical.
// Between them, the eliminated rows determine the mode's conditions and their zeros. Forces that stay undetermined are
// eliminated from the conditions, pair by pair, by the method of Fourier and Motzkin; an interval of loads with a
// solution ends where one of the remaining forms vanishes. In space (where the load is a parameter) friction that is
// determined leaves its cone where T1^2 + T2^2 - (mu N)^2 vanishes.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "mechanics/family/compiled_family.hpp"
#include "mechanics/lines/critical_set.hpp"
#include "mechanics/lines/line.hpp"
#include "mechanics/lines/polynomial_rows.hpp"
#include "mechanics/mechanism/system.hpp"

namespace slipproof {

using LineEvaluator = Evaluator<LineFunction, LineField>;

/// The family's symbols along a line. For a limit, `grows` is the parameter that takes the place of the force.
LineEvaluator evaluator_along(const Line& line, const CompiledFamily& family, LineField field,
                              std::optional<std::size_t> grows = std::nullopt);

class LineMechanism {
 public:
  /// `symbols` has the values of the family's parameters along the line; critical polynomials are added to its field's
  /// set. Both must outlive it.
  LineMechanism(const CompiledFamily& family, LineEvaluator& symbols);

  /// False if a coefficient has no value along the whole line; then there are no motions.
  bool has_value() const { return system_.has_value(); }
  /// Adds the critical polynomials of a mode. Assigns values in `symbols` to the wanted slots of quantities if the
  /// force determines them. False if the mode has no solution along the whole line, or is skipped because eliminating
  /// undetermined forces takes too many forms.
  bool add_mode(const MechanismMode& mode, const std::vector<std::size_t>& wanted);

  /// The equations of a mode, each multiplied by a critical polynomial.
  std::vector<PolynomialRow> equations(const MechanismMode& mode) const;

  /// A form with polynomial coefficients.
  struct ScaledRow {
    PolynomialRow row;
    IntegerPolynomial factor;  ///< the polynomial that the form was multiplied by
  };

 private:
  /// The equations and conditions of an element's state, over the unknowns that the mechanism's own equations leave
  /// open.
  struct StateRows {
    std::vector<PolynomialRow> equations, conditions;
    std::vector<ScaledRow> cone;  ///< T1, T2 and the limit of a contact in space that sticks
  };
  /// The solved equations that all modes share.
  const SolvedRows& in_every_mode();
  ScaledRow reduced(const FormRow<LineFunction>& form);
  const StateRows& rows_of(std::size_t element, ElementState state);
  /// False if its forces are not determined.
  bool add_cone(std::vector<ScaledRow> cone, const SolvedRows& solved);
  /// False if there are too many combinations.
  bool add_conditions(Conditions conditions, const std::vector<std::size_t>& free);

  const CompiledFamily& family_;
  LineEvaluator& symbols_;
  CriticalSet& found_;
  std::optional<MechanismSystem<LineFunction>> system_;
  LineFunction load_ = LineFunction::force();  ///< over the force variable
  std::optional<SolvedRows> in_every_mode_;
  std::vector<std::map<ElementState, StateRows>> rows_;  ///< by element; filled when a mode first has the state
};

}  // namespace slipproof
