// A lower bound on the least singular value of a sparse matrix, which is how far it is from singular.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/algebra/sparse_matrix.hpp"

namespace slipproof {

/// Approximate solutions of sparse systems: elimination with pivots in an order that keeps the factors sparse.
class SparseFactor {
 public:
  /// Factors a matrix; nothing if the elimination breaks down.
  static std::optional<SparseFactor> of(const SparseMatrix& A);
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;
  ~SparseFactor();

  std::vector<double> solve(std::span<const double> b) const;
  std::vector<double> solve_transposed(std::span<const double> b) const;

 private:
  struct Factors;
  explicit SparseFactor(std::unique_ptr<Factors> factors);
  std::unique_ptr<Factors> factors_;
};

/// Estimates the least singular value of an n x n matrix by inverse iteration; 0 if that breaks down.
double guessed_singular_value(std::size_t n, const SparseFactor& factor);

/// A lower bound s > 0 on the least singular value: |A x| >= s |x| for all x, in the Euclidean norm. Nothing if none
/// was found, as for matrices with a condition number above about 10^12. Rows and columns should have norms near 1.
///
/// Inverse iteration guesses the least singular value. Cholesky's method in numbers of 106 bits then shows that A^T A -
/// t I has no negative eigenvalue: if it completes, its input is within gamma_(n+1) trace(A^T A) of a semidefinite
/// matrix (Demmel 1989; Rump 2006), gamma_k = k u / (1 - k u). A^T A was rounded by at most as much, so it has no
/// eigenvalue below t - 2 gamma trace. The time is that of a sparse factorisation of A^T A, times 20.
std::optional<double> least_singular_value(const SparseMatrix& A, const SparseFactor& factor);

/// A smaller bound that is quick to prove again: in this order of A's columns Cholesky's method for A^T A - 2 value^2
/// I, with L rounded down to multiples of 2^-grid, completes, and leaves less than value^2 in each row. A^T A - 2
/// value^2 I has no eigenvalue below value^2; rounding leaves at most n 2^-grid times the largest norm of a column of A
/// in a row, which is value^2 / 4 at most.
struct SingularValueProof {
  double value = 0;
  int grid = 0;
  std::vector<std::size_t> order;
};
std::optional<SingularValueProof> prove_singular_value(const SparseMatrix& A, const SparseFactor& factor);

}  // namespace slipproof
