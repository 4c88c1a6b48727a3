#include "base/algebra/sparse_matrix.hpp"

#include <algorithm>
#include <tuple>

namespace slipproof {

SparseMatrix sparse_matrix(std::size_t rows, std::size_t columns, std::vector<MatrixEntry> entries,
                           std::vector<MatrixEntry>& twice) {
  const auto place = [](const MatrixEntry& e) { return std::tuple(e.row, e.column); };
  std::stable_sort(entries.begin(), entries.end(),
                   [&](const MatrixEntry& a, const MatrixEntry& b) { return place(a) < place(b); });
  const auto again = std::adjacent_find(
      entries.begin(), entries.end(), [&](const MatrixEntry& a, const MatrixEntry& b) { return place(a) == place(b); });
  if (again != entries.end()) twice = {*again, *(again + 1)};
  SparseMatrix result;
  result.rows = rows;
  result.columns = columns;
  result.starts.assign(rows + 1, 0);
  for (const MatrixEntry& e : entries) {
    ++result.starts[e.row + 1];
    result.column.push_back(e.column);
    result.value.push_back(e.value);
  }
  for (std::size_t i = 0; i < rows; ++i) result.starts[i + 1] += result.starts[i];
  return result;
}

SparseMatrix transposed(const SparseMatrix& matrix) {
  SparseMatrix result;
  result.rows = matrix.columns;
  result.columns = matrix.rows;
  result.starts.assign(matrix.columns + 1, 0);
  result.column.resize(matrix.entries());
  result.value.resize(matrix.entries());
  for (const std::uint32_t j : matrix.column) ++result.starts[j + 1];
  for (std::size_t j = 0; j < matrix.columns; ++j) result.starts[j + 1] += result.starts[j];
  std::vector<std::size_t> next(result.starts.begin(), result.starts.end() - 1);
  for (std::size_t i = 0; i < matrix.rows; ++i) {
    for (std::size_t k = matrix.starts[i]; k < matrix.starts[i + 1]; ++k) {
      const std::size_t at = next[matrix.column[k]]++;
      result.column[at] = static_cast<std::uint32_t>(i);
      result.value[at] = matrix.value[k];
    }
  }
  return result;
}

SparseMatrix from_dense(std::size_t rows, std::size_t columns, std::span<const double> dense) {
  SparseMatrix result;
  result.rows = rows;
  result.columns = columns;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      if (dense[i * columns + j] == 0) continue;
      result.column.push_back(static_cast<std::uint32_t>(j));
      result.value.push_back(dense[i * columns + j]);
    }
    result.starts.push_back(result.value.size());
  }
  return result;
}

}  // namespace slipproof
