// Linear programs in floating point, by Clp.
#pragma once

#include <memory>
#include <vector>

namespace slipproof {

/// A program in columns with values >= 0, and a slack of each sign for each row:
///   minimize the costs, with   sum of columns + slack = right side   in each row that is not free.
/// The slacks are basic to begin with, and cost 1. Not for more than one thread at a time.
class ColumnProgram {
 public:
  struct Entry {
    int row;
    double value;
  };
  using Column = std::vector<Entry>;

  /// Throws std::runtime_error in a build without Clp.
  ColumnProgram(const std::vector<double>& right_side, const std::vector<bool>& free_rows,
                const std::vector<Column>& columns);
  ~ColumnProgram();
  ColumnProgram(const ColumnProgram&) = delete;
  ColumnProgram& operator=(const ColumnProgram&) = delete;

  /// Of any sign from here on. Before the first solve().
  void make_free(std::size_t column);
  /// In place of the usual limit.
  void allow_pivots(int most);
  /// From where the last one ended. False where it has no optimum, or was given up.
  bool solve(double tolerance);
  void set_cost(std::size_t column, double cost);
  /// From here on slacks cost nothing and are at most this.
  void bound_slacks(double most);

  double least() const;  ///< of the costs
  double value(std::size_t column) const;
  double price(std::size_t row) const;  ///< the multiplier of a row
  bool is_basic(std::size_t column) const;

 private:
  void begin_with_slacks();

  struct Clp;
  std::unique_ptr<Clp> clp_;
  std::size_t rows_;
};

}  // namespace slipproof
