// Square systems that are mostly zero, solved exactly: an LU decomposition over rationals in Markowitz's order
// (Management Science 3 (1957) 255): each pivot is in a column, and then a row, with few other entries, so that little
// fills in.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/number/effort.hpp"
#include "base/number/rational.hpp"

namespace slipproof {

/// Rows and entries that are not 0; each row at most once.
using SparseVector = std::vector<std::pair<std::uint32_t, Rational>>;

class SparseBasis {
 public:
  /// Eliminates. Columns that depend on those before them in the order of elimination get no pivot: dependent(); as
  /// many rows as are left without one: free_rows(). solve() and solve_transposed() need a pivot in each row and
  /// column. Throws TooMuchWork.
  SparseBasis(std::size_t rows, const std::vector<const SparseVector*>& columns, Effort& effort);

  const std::vector<std::size_t>& dependent() const { return dependent_; }
  const std::vector<std::size_t>& free_rows() const { return free_rows_; }

  /// x with B x = b.
  std::vector<Rational> solve(std::vector<Rational> b) const;
  /// y with B^T y = c.
  std::vector<Rational> solve_transposed(std::vector<Rational> c) const;

 private:
  struct Pivot {
    std::uint32_t row, column;
    Rational value;
    SparseVector others;  ///< by column: those that have their pivots later
  };
  struct Step {
    std::uint32_t row, from;
    Rational factor;  ///< row -= factor * from
  };
  class Elimination;

  std::size_t rows_, columns_;
  std::vector<Pivot> pivots_;
  std::vector<Step> steps_;
  std::vector<std::size_t> dependent_, free_rows_;
};

}  // namespace slipproof
