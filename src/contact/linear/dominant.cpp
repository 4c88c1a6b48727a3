#include "contact/linear/dominant.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

#include "base/rounding/exact_sum.hpp"

namespace slipproof {

namespace {

/// Row i of the comparison matrix times d: a_ii d_i - sum |a_ij| d_j, here in floating point.
double compared_row(const SparseMatrix& A, std::size_t i, std::span<const double> d) {
  double sum = 0;
  for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) {
    const std::size_t j = A.column[k];
    sum += (j == i ? A.value[k] : -std::abs(A.value[k])) * d[j];
  }
  return sum;
}

bool seems_dominant(const SparseMatrix& A, std::span<const double> d) {
  for (std::size_t i = 0; i < A.rows; ++i) {
    if (!(d[i] > 0 && compared_row(A, i, d) > 0)) return false;
  }
  return true;
}

std::vector<double> diagonal_of(const SparseMatrix& A) {
  std::vector<double> result(A.rows);
  for (std::size_t i = 0; i < A.rows; ++i) {
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) {
      if (A.column[k] == i) result[i] = A.value[k];
    }
  }
  return result;
}

/// The d of a matrix M with |.| off its diagonal solves M d = (a_11, a_22, ...), and any d near it will do. Sweeps of
/// Gauss and Seidel converge to it from below if and only if A is an H-matrix; a few of them do for most.
std::optional<std::vector<double>> scale_by_sweeps(const SparseMatrix& A, const std::vector<double>& diagonal) {
  constexpr int sweeps = 24, sweeps_a_test = 4;
  std::vector<double> d(A.rows, 1);
  if (seems_dominant(A, d)) return d;
  for (int sweep = 1; sweep <= sweeps; ++sweep) {
    for (std::size_t i = 0; i < A.rows; ++i) d[i] += 1 - compared_row(A, i, d) / diagonal[i];
    if (sweep % sweeps_a_test == 0 && seems_dominant(A, d)) return d;
  }
  return std::nullopt;
}

/// Where sweeps converge too slowly.
std::vector<double> scale_by_dense_elimination(const SparseMatrix& A, const std::vector<double>& diagonal) {
  const auto n = static_cast<Eigen::Index>(A.rows);
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t i = 0; i < A.rows; ++i) {
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) {
      const double value = A.column[k] == i ? A.value[k] : -std::abs(A.value[k]);
      m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(A.column[k])) = value;
    }
  }
  const Eigen::VectorXd d = m.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), n));
  return {d.data(), d.data() + n};
}

std::vector<double> scale_by_sparse_elimination(const SparseMatrix& A, const std::vector<double>& diagonal) {
  const auto n = static_cast<Eigen::Index>(A.rows);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < A.rows; ++i) {
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) {
      const double value = A.column[k] == i ? A.value[k] : -std::abs(A.value[k]);
      entries.emplace_back(static_cast<int>(i), static_cast<int>(A.column[k]), value);
    }
  }
  Eigen::SparseMatrix<double> m(n, n);
  m.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(m);
  if (lu.info() != Eigen::Success) return {};
  const Eigen::VectorXd d = lu.solve(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), n));
  return {d.data(), d.data() + n};
}

std::vector<double> scale_by_elimination(const SparseMatrix& A, const std::vector<double>& diagonal, Effort& effort) {
  constexpr std::size_t sparse_part = 16;  // of all entries: what fills a matrix with more than this in elimination
  const Work n = A.rows;
  if (A.entries() > n * n / sparse_part) {
    effort.spend(times(n * n, n / 2));
    return scale_by_dense_elimination(A, diagonal);
  }
  effort.spend(n * n);  // as of a grid in space
  return scale_by_sparse_elimination(A, diagonal);
}

}  // namespace

bool has_positive_diagonal(const SparseMatrix& A) {
  const std::vector<double> diagonal = diagonal_of(A);
  return std::all_of(diagonal.begin(), diagonal.end(), [](double x) { return x > 0; });
}

bool is_dominant(const SparseMatrix& A, std::span<const double> d) {
  if (d.size() != A.rows || A.rows != A.columns || !has_positive_diagonal(A)) return false;
  if (!std::all_of(d.begin(), d.end(), [](double x) { return x > 0 && std::isfinite(x); })) return false;
  for (std::size_t i = 0; i < A.rows; ++i) {
    ExactSum sum;
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) {
      const std::size_t j = A.column[k];
      sum.add(j == i ? A.value[k] : -std::abs(A.value[k]), d[j]);
    }
    if (sign(sum.value()) <= 0) return false;
  }
  return true;
}

std::optional<std::vector<double>> dominant_scale(const SparseMatrix& A, Effort& effort) {
  effort.spend(times(200, A.entries() + A.rows));
  const std::vector<double> diagonal = diagonal_of(A);
  auto d = scale_by_sweeps(A, diagonal);
  if (!d || !is_dominant(A, *d)) d = scale_by_elimination(A, diagonal, effort);
  if (!is_dominant(A, *d)) return std::nullopt;
  return d;
}

}  // namespace slipproof
