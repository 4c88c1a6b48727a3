// Matrices of binary64 numbers that are mostly zero, as solvers of contact write them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace slipproof {

/// Rows, one after the other: row i has its entries from starts[i] to starts[i + 1], with columns that increase. No
/// entry stands twice; a stored entry may be 0.
struct SparseMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<std::size_t> starts = {0};  ///< rows + 1 of them
  std::vector<std::uint32_t> column;
  std::vector<double> value;

  std::size_t entries() const { return value.size(); }
  /// Of a row: where its entries begin and end in `column` and `value`.
  std::span<const std::uint32_t> columns_of(std::size_t row) const {
    return {column.data() + starts[row], column.data() + starts[row + 1]};
  }
  std::span<const double> values_of(std::size_t row) const {
    return {value.data() + starts[row], value.data() + starts[row + 1]};
  }
  bool operator==(const SparseMatrix&) const = default;
};

/// One entry where it stands, counted from 0.
struct MatrixEntry {
  std::uint32_t row = 0, column = 0;
  double value = 0;
};

/// Entries in any order; all of them lie inside. An entry that stands twice is a mistake of whoever made them: `twice`
/// gets the first one with its second, and stays empty otherwise. Linear but for sorting.
SparseMatrix sparse_matrix(std::size_t rows, std::size_t columns, std::vector<MatrixEntry> entries,
                           std::vector<MatrixEntry>& twice);

SparseMatrix transposed(const SparseMatrix& matrix);

/// Entry by entry, zeros left out. `dense` holds the rows one after the other.
SparseMatrix from_dense(std::size_t rows, std::size_t columns, std::span<const double> dense);

}  // namespace slipproof
