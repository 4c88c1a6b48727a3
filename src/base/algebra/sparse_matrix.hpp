// Matrices of binary64 numbers that are mostly zero, as solvers of contact write them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slipproof {

/// Stores rows one after the other: row i has its entries from starts[i] to starts[i + 1], with increasing columns.
/// There are no duplicate entries; a stored entry may be 0.
struct SparseMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<std::size_t> starts = {0};  ///< rows + 1 of them
  std::vector<std::uint32_t> column;
  std::vector<double> value;

  std::size_t entries() const { return value.size(); }
  /// The columns and values of a row.
  std::span<const std::uint32_t> columns_of(std::size_t row) const {
    return {column.data() + starts[row], column.data() + starts[row + 1]};
  }
  std::span<const double> values_of(std::size_t row) const {
    return {value.data() + starts[row], value.data() + starts[row + 1]};
  }
  bool operator==(const SparseMatrix&) const = default;
};

/// An entry with its row and column, counted from 0.
struct MatrixEntry {
  std::uint32_t row = 0, column = 0;
  double value = 0;
};

/// Makes a matrix from entries in any order, all within its size. If an entry occurs twice, `twice` gets both
/// occurrences; otherwise it stays empty. Linear time except for sorting.
SparseMatrix sparse_matrix(std::size_t rows, std::size_t columns, std::vector<MatrixEntry> entries,
                           std::vector<MatrixEntry>& twice);

SparseMatrix transposed(const SparseMatrix& matrix);

/// Entry by entry, zeros left out. `dense` holds the rows one after the other.
SparseMatrix from_dense(std::size_t rows, std::size_t columns, std::span<const double> dense);

}  // namespace slipproof
