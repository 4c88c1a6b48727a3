// Square linear systems in binary64 numbers, solved exactly at sizes of a thousand.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/algebra/sparse_matrix.hpp"
#include "base/number/effort.hpp"

namespace slipproof {

/// Numbers with a common positive denominator, not necessarily in lowest terms.
struct ExactVector {
  std::vector<Integer> numerators;
  Integer denominator = 1;

  std::size_t size() const { return numerators.size(); }
  int sign(std::size_t i) const { return numerators[i].sign(); }
  Rational at(std::size_t i) const { return Rational(numerators[i], denominator); }
};

ExactVector over_one_denominator(const std::vector<Rational>& x);

/// A x + c in each row, exactly; `c` has an entry for each row.
ExactVector exact_rows(const SparseMatrix& A, const ExactVector& x, std::span<const double> c);

/// The x with A x + c = 0; nothing if A is singular. Throws TooMuchWork, before it begins. By p-adic lifting, O(n^3 b)
/// for n rows of numbers of b bits: 1,000 full rows of random numbers take ten seconds and 100 MB, as the solution has
/// 130,000 bits in each component. Matrices with few entries in a row are eliminated in a sparse order first
/// (sparse_basis.hpp), which is near linear where little fills in.
std::optional<ExactVector> exact_solution(const SparseMatrix& A, std::span<const double> c, Effort& effort);

}  // namespace slipproof
