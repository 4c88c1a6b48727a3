// Linear equations with exact coefficients. FLINT eliminates: without fractions, or by residues if the matrix is large.
#pragma once

#include <cstddef>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof {

using IntegerMatrix = std::vector<std::vector<Integer>>;
using RationalMatrix = std::vector<std::vector<Rational>>;

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

/// Multiplies a row by the common denominator of its entries.
std::vector<Integer> clear_denominators(const std::vector<Rational>& row);

/// A matrix in reduced row echelon form, times `pivot`: each of the first rank() rows has `pivot` in its pivot column,
/// where all other rows have 0. The rows beyond the rank are 0.
struct Echelon {
  IntegerMatrix rows;
  std::vector<std::size_t> pivot_columns;  ///< ascending
  Integer pivot = 1;                       ///< may be negative

  std::size_t rank() const { return pivot_columns.size(); }
  /// The rank of the first columns. The others may be right-hand sides: they have solutions if this is rank().
  std::size_t rank(std::size_t columns) const;
};

Echelon eliminate(IntegerMatrix matrix);
Echelon eliminate(const RationalMatrix& matrix);
Rational determinant(const RationalMatrix& matrix);

/// One step of Bareiss's elimination of a square matrix: returns the new entries below row k and right of column k.
/// Entry (k, k) must not be 0. `previous` is the pivot of the previous step, or 1; it divides the new entries exactly,
/// since these are minors.
IntegerMatrix eliminated_once(const IntegerMatrix& matrix, std::size_t k, const Integer& previous);

}  // namespace slipproof
