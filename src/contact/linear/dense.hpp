// The two operations on dense matrices that cost n^3: everything else about an enclosure costs n^2.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace slipproof {

/// Rows one after the other.
struct DenseMatrix {
  std::size_t size = 0;
  std::vector<double> value;

  explicit DenseMatrix(std::size_t n = 0) : size(n), value(n * n) {}
  std::span<const double> row(std::size_t i) const { return {value.data() + i * size, size}; }
  std::span<double> row(std::size_t i) { return {value.data() + i * size, size}; }
};

/// An approximate inverse, nothing said about its error; infinities or NaN in it where elimination breaks down. About
/// 8/3 n^3 operations, with the widest vectors that the machine has, and the same bits with any.
DenseMatrix approximate_inverse(DenseMatrix matrix);

/// The absolute values of the entries of I - R A as computed. Each is a sum of 1 or 0 and n products, one after the
/// other, so apart from underflow it differs from the exact one by at most gamma_(n+1) (|R| |A| + I). 2 n^3 operations.
DenseMatrix absolute_defect(const DenseMatrix& R, const DenseMatrix& A);

}  // namespace slipproof
