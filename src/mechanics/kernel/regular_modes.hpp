// Modes whose equations have one solution for each load, solved in integers; greatest common divisors are taken only of
// numbers that are returned.
//
// A form multiplied by the common denominator of its numbers is a row of integers with the same solutions and signs.
// Rows with one or two unknowns and no constant (a force that is 0, friction at its limit) are eliminated first, by
// substitution, and the rest by fraction-free elimination. Modes with no solution or several are left to linear
// programs.
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
  /// Prepares modes with these states at one load, or for all loads: copies the needed parts of the problem into
  /// integers.
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
      regular        ///< one solution for each load
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
    std::vector<std::size_t> unknowns;  ///< those with a nonzero coefficient
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
  std::vector<Row> equations_;                  ///< common to all modes
  std::vector<std::vector<StateRows>> states_;  ///< by element and state
  std::size_t bits_ = 0;                        ///< bits of the longest number
};

}  // namespace slipproof
