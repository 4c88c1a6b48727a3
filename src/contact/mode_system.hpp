// The equations of a mode of a contact problem, in integers: no gcd before it is known which numbers are asked for.
#pragma once

#include <utility>
#include <vector>

#include "contact/problem.hpp"
#include "number/bareiss.hpp"
#include "number/raw_fraction.hpp"

namespace slipproof {

/// A problem in integers. Rows of W and q are multiplied by something positive: neither solutions nor signs change.
struct ScaledProblem {
  explicit ScaledProblem(const ContactProblem& problem);

  std::vector<std::vector<Integer>> rows;  ///< W, then q
  std::vector<Integer> factor;             ///< what each row was multiplied by
  std::vector<Integer> friction, unit;     ///< mu = friction / unit of each contact
  std::size_t bits = 0;                    ///< of the longest number

  /// The left-hand side of a condition for z / pivot.
  RawFraction condition_value(const ProblemCondition& condition, const std::vector<Integer>& z,
                              const Integer& pivot) const;

 private:
  Integer acceleration(std::size_t row, const std::vector<Integer>& z, const Integer& pivot) const;
};

/// How many components of z a mode leaves open.
std::size_t unknown_count(const ContactProblem& problem, const ProblemMode& mode);

/// What remains of a mode's equations after elimination.
class ModeSystem {
 public:
  ModeSystem(const ScaledProblem& problem, const ProblemMode& mode);

  bool solvable() const;
  bool unique() const { return echelon_.rank() == columns_.size(); }
  std::size_t rank() const { return echelon_.rank(); }
  std::size_t free_count() const { return columns_.size() - rank(); }
  const Integer& pivot() const { return echelon_.pivot; }

  /// z times the pivot; of a unique solution.
  std::vector<Integer> scaled_solution() const;
  /// z where all that is free is 0.
  std::vector<Rational> solution() const;
  /// What each of the free unknowns adds to it.
  RationalMatrix directions() const;

 private:
  /// z = the sum of y_k columns[k]: the forces that the mode leaves open, each with the components that it drives.
  using Column = std::vector<std::pair<std::size_t, Integer>>;
  void add(std::vector<Rational>& z, std::size_t k, const Rational& y) const;

  std::size_t size_;
  std::vector<Column> columns_;
  Echelon echelon_;
};

}  // namespace slipproof
