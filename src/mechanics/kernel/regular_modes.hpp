// Modes whose equations have one solution for each load, solved in integers: no gcd before it is known which numbers
// are asked for.
//
// A form times the common denominator of its numbers is a row of integers; solutions and signs stay what they are. Rows
// of one or two unknowns without a constant (a force that is 0, friction at its limit) go first: each leaves an unknown
// out. Fraction-free elimination takes the rest. A mode that has no solution or several is left to linear programs.
#pragma once

#include <optional>
#include <vector>

#include "base/algebra/elimination.hpp"
#include "base/number/effort.hpp"
#include "base/number/raw_fraction.hpp"
#include "mechanics/elements/state_rows.hpp"
#include "mechanics/kernel/motion.hpp"

namespace slipproof {

class RegularModes {
 public:
  /// At one load, or for all. Copies the parts of the problem that modes of these states need into integers.
  RegularModes(const FrictionProblem& problem, const std::optional<Rational>& load, const StatesOfElements& states);

  /// A condition that the one solution at a load violates, the first one.
  struct Violation {
    ViolatedCondition condition;
    Rational margin;  ///< negative
  };
  struct Outcome {
    enum class Kind {
      singular,      ///< none or several solutions for some loads
      inconsistent,  ///< none; only at a load
      violated,      ///< one, which breaks a condition; only at a load
      regular        ///< one for each load
    };
    Kind kind = Kind::singular;
    std::optional<Violation> violation;
    std::optional<AffineSpace> space;  ///< regular: the solution
    /// Regular, for all loads: the conditions on it, in integers times positive numbers where they vary.
    std::vector<AffineForm> conditions;
  };
  /// A state for each element. Takes one elimination, with an effort: throws TooMuchWork beyond it.
  Outcome solve(const MechanismMode& mode, Effort* effort) const;

  /// The work of a mode that leaves this many unknowns to elimination.
  Work work_of(std::size_t unknowns) const;

 private:
  /// Coefficients of the unknowns, the constant and, for all loads, the coefficient of the load; times `factor`.
  struct Row {
    std::vector<Integer> entries;
    Integer factor;
    std::vector<std::size_t> unknowns;  ///< with a coefficient that is not 0
    bool homogeneous;                   ///< neither constant nor load
  };
  struct StateRows {
    std::vector<Row> equations;
    std::vector<std::pair<Row, StateCondition>> conditions;
  };
  class Elimination;

  Row row_of(const AffineForm& form);

  std::size_t unknowns_;
  std::optional<Rational> load_;  ///< the one load there is, 0 where the problem has none
  std::size_t right_sides_;
  std::vector<Row> equations_;                  ///< of every mode
  std::vector<std::vector<StateRows>> states_;  ///< for each element, by the number of the state
  std::size_t bits_ = 0;                        ///< of the longest number
};

}  // namespace slipproof
