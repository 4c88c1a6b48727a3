// Matrices as files give them: entry by entry, in any order.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/algebra/sparse_matrix.hpp"

namespace slipproof {

/// The matrix of these entries. For a duplicate entry, calls `twice(message)`, which must throw: "found the entry in
/// row 3 and column 4 twice, expected it once", counted from 1.
template <class Refuse>
SparseMatrix matrix_of(std::size_t rows, std::size_t columns, std::vector<MatrixEntry> entries, Refuse&& twice) {
  std::vector<MatrixEntry> again;
  SparseMatrix result = sparse_matrix(rows, columns, std::move(entries), again);
  if (!again.empty()) {
    twice("found the entry in row " + std::to_string(again[0].row + std::size_t{1}) + " and column " +
          std::to_string(again[0].column + std::size_t{1}) + " twice, expected it once");
  }
  return result;
}

/// Puts an entry that is not 0.
inline void put_entry(std::vector<MatrixEntry>& entries, std::size_t row, std::size_t column, double value) {
  if (value == 0) return;
  entries.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column), value});
}

}  // namespace slipproof
