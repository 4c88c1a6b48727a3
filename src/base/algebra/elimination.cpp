#include "base/algebra/elimination.hpp"

#include <algorithm>
#include <utility>

#include "base/algebra/flint_matrix.hpp"

namespace slipproof {

namespace {

void exchange(FlintMatrix& flint, IntegerMatrix& matrix) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < matrix[i].size(); ++j) fmpz_swap(flint.at(i, j), matrix[i][j].flint());
  }
}

}  // namespace

std::vector<Integer> clear_denominators(const std::vector<Rational>& row) {
  const Integer common = common_denominator(row);
  std::vector<Integer> integers;
  integers.reserve(row.size());
  for (const Rational& x : row) integers.push_back(integer_times(x, common));
  return integers;
}

std::size_t Echelon::rank(std::size_t columns) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(pivot_columns, columns) - pivot_columns.begin());
}

Echelon eliminate(IntegerMatrix matrix) {
  Echelon result;
  FlintMatrix flint(matrix.size(), matrix.empty() ? 0 : matrix.front().size());
  exchange(flint, matrix);
  const slong rank = fmpz_mat_rref(flint.get(), result.pivot.flint(), flint.get());
  exchange(flint, matrix);
  for (std::size_t i = 0, column = 0; i < static_cast<std::size_t>(rank); ++i, ++column) {
    while (matrix[i][column].is_zero()) ++column;
    result.pivot_columns.push_back(column);
  }
  result.rows = std::move(matrix);
  return result;
}

Echelon eliminate(const RationalMatrix& matrix) {
  IntegerMatrix rows;
  rows.reserve(matrix.size());
  for (const std::vector<Rational>& row : matrix) rows.push_back(clear_denominators(row));
  return eliminate(std::move(rows));
}

Rational determinant(const RationalMatrix& matrix) {
  FlintRationalMatrix flint(matrix.size(), matrix.size());
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < matrix.size(); ++j) flint.set(i, j, matrix[i][j]);
  }
  return flint.determinant();
}

IntegerMatrix eliminated_once(const IntegerMatrix& matrix, std::size_t k, const Integer& previous) {
  IntegerMatrix result;
  for (std::size_t i = k + 1; i < matrix.size(); ++i) {
    std::vector<Integer>& row = result.emplace_back();
    for (std::size_t j = k + 1; j < matrix.size(); ++j) {
      Integer minor = matrix[k][k] * matrix[i][j];
      minor.subtract_product(matrix[i][k], matrix[k][j]);
      row.push_back(exact_quotient(minor, previous));
    }
  }
  return result;
}

}  // namespace slipproof
