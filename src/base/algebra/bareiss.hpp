// Fraction-free elimination on integers (Bareiss): every intermediate value is a minor of the matrix, so the exact
// division by the previous pivot replaces all gcds.
#pragma once

#include <cstddef>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof {

using IntegerMatrix = std::vector<std::vector<Integer>>;

/// The least common multiple of the denominators, and of `result`; `values` is a range of Rational, or of references to
/// it.
template <class Range>
Integer common_denominator(const Range& values, Integer result = 1) {
  for (const Rational& value : values) {
    const Integer& d = denominator(value);
    if (d != 1 && d != result) result = lcm(result, d);
  }
  return result;
}

/// value * multiple, where `multiple` is one of the value's denominator.
inline Integer integer_times(const Rational& value, const Integer& multiple) {
  return numerator(value) * exact_quotient(multiple, denominator(value));
}

/// A row times the common denominator of its entries.
inline std::vector<Integer> clear_denominators(const std::vector<Rational>& row) {
  const Integer common = common_denominator(row);
  std::vector<Integer> integers;
  integers.reserve(row.size());
  for (const Rational& x : row) integers.push_back(integer_times(x, common));
  return integers;
}

/// A matrix in reduced row echelon form times `pivot`: in each of the first rank() rows the pivot column holds `pivot`
/// and the other pivot columns 0.
struct Echelon {
  IntegerMatrix rows;                      ///< rows beyond the rank are zero in the eliminated columns
  std::vector<std::size_t> pivot_columns;  /// increasing
  Integer pivot = 1;

  std::size_t rank() const { return pivot_columns.size(); }
};

/// Eliminates the first `columns` columns; the others (right-hand sides) are carried along.
inline Echelon eliminate(IntegerMatrix matrix, std::size_t columns) {
  Echelon result;
  Integer previous = 1;
  std::size_t rank = 0;
  for (std::size_t column = 0; column < columns && rank < matrix.size(); ++column) {
    std::size_t source = rank;
    while (source < matrix.size() && matrix[source][column].is_zero()) ++source;
    if (source == matrix.size()) continue;
    if (source != rank) {
      matrix[source].swap(matrix[rank]);
      for (Integer& x : matrix[rank]) x = -x;  // keeps the pivots minors of the original, sign included
    }
    const std::vector<Integer> pivot_row = matrix[rank];
    const Integer& pivot = pivot_row[column];
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      if (i == rank) continue;
      const Integer factor = matrix[i][column];
      for (std::size_t j = 0; j < matrix[i].size(); ++j) {
        Integer value = pivot * matrix[i][j];
        value.subtract_product(factor, pivot_row[j]);
        matrix[i][j] = exact_quotient(value, previous);
      }
    }
    previous = pivot;
    result.pivot_columns.push_back(column);
    ++rank;
  }
  result.rows = std::move(matrix);
  result.pivot = previous;
  return result;
}

}  // namespace slipproof
