// Small linear programs, solved exactly.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "base/number/effort.hpp"
#include "base/number/rational.hpp"

namespace slipproof {

/// constant + coefficients . x
struct AffineForm {
  Rational constant;
  std::vector<Rational> coefficients;

  Rational at(const std::vector<Rational>& x) const;
};

struct LinearOptimum {
  enum class Kind { infeasible, unbounded, attained, given_up };
  Kind kind = Kind::infeasible;
  Rational value;           ///< least value of the objective; only if attained
  std::vector<Rational> x;  ///< a point with that value; unbounded: a feasible point
  /// A multiplier >= 0 for each constraint, only if the value is attained: objective = value + the sum of multiplier *
  /// constraint, for all x.
  std::vector<Rational> multipliers;
  std::size_t pivots = 0;
};

/// The least value of the objective over all x, of any sign, with every constraint >= 0. All forms have as many
/// coefficients as the objective. Uses the simplex method on dictionaries with Bland's rule, which terminates without a
/// tolerance; gives up after that many pivots.
LinearOptimum minimize(const AffineForm& objective, const std::vector<AffineForm>& constraints,
                       std::size_t max_pivots = std::numeric_limits<std::size_t>::max());

/// The same with a limit on the work. Throws TooMuchWork if it is exceeded.
LinearOptimum minimize(const AffineForm& objective, const std::vector<AffineForm>& constraints, Effort& effort);

/// A linear program for several objectives under the same constraints. Each starts at the vertex where the previous one
/// ended.
class LinearProgram {
 public:
  /// Each constraint must have `variables` coefficients.
  LinearProgram(std::size_t variables, const std::vector<AffineForm>& constraints);
  ~LinearProgram();
  LinearProgram(const LinearProgram&) = delete;
  LinearProgram& operator=(const LinearProgram&) = delete;

  bool is_feasible() const { return is_feasible_; }
  /// The least value of an objective of a feasible program; nothing if it is unbounded.
  std::optional<Rational> least(const AffineForm& objective);

 private:
  class Dictionary;
  friend LinearOptimum minimize(const AffineForm& objective, const std::vector<AffineForm>& constraints,
                                std::size_t max_pivots);

  std::unique_ptr<Dictionary> dictionary_;
  bool is_feasible_;
};

}  // namespace slipproof
