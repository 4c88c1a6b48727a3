// Linear programs that are mostly zero, solved exactly from a basis that somebody proposes.
#pragma once

#include <vector>

#include "base/algebra/sparse/sparse_basis.hpp"

namespace slipproof {

/// A column of a program. Its value is >= 0, or of any sign if it is free.
struct ProgramColumn {
  SparseVector entries;
  Rational cost;
  bool is_free = false;
};

/// minimise the costs, where the sum of the columns is the right side.
struct SparseProgram {
  std::vector<Rational> right_side;
  std::vector<ProgramColumn> columns;

  std::size_t rows() const { return right_side.size(); }
};

struct SparseOptimum {
  enum class Kind { optimal, infeasible, unbounded };
  Kind kind = Kind::infeasible;
  std::vector<Rational> x;  ///< of each column; unbounded: a feasible point
  /// Of each row. optimal: y . column <= cost for each column, equal if it is free, and y . right side is the least
  /// cost. infeasible: y . column <= 0, equal if it is free, and y . right side > 0.
  std::vector<Rational> y;
  std::vector<Rational> direction;  ///< unbounded: x + any multiple >= 0 of it is feasible, and costs ever less
  std::vector<std::size_t> basis;   ///< where it ended
  std::size_t pivots = 0;
};

/// The simplex method on bases, each decomposed anew: for a basis in which little is left to do, such as the last one
/// of a floating-point solver, or for a small program. `basis` lists columns, at most one a row and no two the same;
/// dependent ones are left out, and rows are filled up. Throws TooMuchWork.
SparseOptimum minimize(const SparseProgram& program, std::vector<std::size_t> basis, Effort& effort);

}  // namespace slipproof
