// That the parts of an ansatz add up to zero: one linear equation for each monomial, exactly, and one more that keeps
// the strict parts from vanishing together.
#pragma once

#include <map>

#include "proofs/sums/ansatz.hpp"
#include "proofs/sums/semidefinite.hpp"

namespace slipproof::prove::sums {

/// Symmetric, row by row, one for each block of an ansatz.
using ExactBlocks = std::vector<std::vector<Rational>>;

/// The equations solved for some of the unknowns. First the coefficients of the multiples are eliminated, which may
/// have any value; the other equations have entries of blocks only.
class Equations {
 public:
  Equations(Context& context, const Ansatz& ansatz);

  bool contradictory() const { return contradictory_; }
  /// The number of equations between entries.
  std::size_t size() const { return rows_.size() - of_multiples_; }
  MatrixEquations in_binary64() const;
  /// Entries that meet the equations: those that they are not solved for come from `near`, rounded to multiples of
  /// 1/denominator.
  ExactBlocks rounded(const MatrixPoint& near, const Integer& denominator) const;
  /// The polynomial that each multiple has for these entries; 0 where it can be.
  std::vector<Polynomial> multipliers(const ExactBlocks& entries) const;

 private:
  using Row = std::map<std::size_t, Rational>;  ///< by column; constant_ stands for the number 1
  struct Solved {
    std::size_t column;  ///< has the factor 1, and is in no other row
    Row row;             ///< is 0
  };
  void number_columns();
  std::vector<Row> equations(Context& context) const;
  void solve(Context& context, std::vector<Row> rows);
  std::size_t pivot_of(const Row& row) const;
  bool is_entry(std::size_t column) const { return column >= entries_from_ && column < constant_; }

  const Ansatz& ansatz_;
  std::vector<MatrixPlace> places_;  ///< places of the columns from entries_from_ on
  std::size_t entries_from_ = 0, constant_ = 0, of_multiples_ = 0;
  std::vector<Solved> rows_;
  bool contradictory_ = false;
};

}  // namespace slipproof::prove::sums
