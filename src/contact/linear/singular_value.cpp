#include "contact/linear/singular_value.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

#include "base/parallel/stop.hpp"
#include "contact/linear/double_double.hpp"

namespace slipproof {

namespace {

namespace singular {

using Matrix = Eigen::SparseMatrix<double>;
using WideMatrix = Eigen::SparseMatrix<DoubleDouble>;

Matrix eigen_matrix(const SparseMatrix& A) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(A.entries());
  for (std::size_t i = 0; i < A.rows; ++i) {
    for (std::size_t e = A.starts[i]; e < A.starts[i + 1]; ++e) {
      entries.emplace_back(static_cast<int>(i), static_cast<int>(A.column[e]), A.value[e]);
    }
  }
  Matrix result(static_cast<Eigen::Index>(A.rows), static_cast<Eigen::Index>(A.columns));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

std::vector<double> normalised(std::vector<double> x) {
  double norm = 0;
  for (const double v : x) norm = std::hypot(norm, v);
  for (double& v : x) v /= norm;
  return x;
}

/// The lower half of A^T A, rounded to 106 bits.
WideMatrix lower_square(const SparseMatrix& A) {
  std::vector<Eigen::Triplet<DoubleDouble>> entries;
  for (std::size_t i = 0; i < A.rows; ++i) {
    const auto columns = A.columns_of(i);
    const auto values = A.values_of(i);
    for (std::size_t a = 0; a < columns.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        entries.emplace_back(static_cast<int>(columns[a]), static_cast<int>(columns[b]),
                             DoubleDouble::product(values[a], values[b]));
      }
    }
  }
  WideMatrix result(static_cast<Eigen::Index>(A.columns), static_cast<Eigen::Index>(A.columns));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

using WideCholesky = Eigen::SimplicialLLT<WideMatrix, Eigen::Lower>;

/// Cholesky's method in 106 bits; null where it does not go to its end.
std::unique_ptr<WideCholesky> cholesky(const WideMatrix& lower, double shift) {
  WideMatrix shifted = lower;
  for (Eigen::Index j = 0; j < shifted.cols(); ++j) shifted.coeffRef(j, j) -= DoubleDouble(shift);
  stop_if_asked();
  auto result = std::make_unique<WideCholesky>(shifted);
  return result->info() == Eigen::Success ? std::move(result) : nullptr;
}

/// A shift for which it does, and what rounding may have hidden.
struct Shifted {
  double shift, lost;
  std::unique_ptr<WideCholesky> cholesky;
};

std::optional<Shifted> largest_shift(const SparseMatrix& A, const SparseFactor& factor);

}  // namespace singular

}  // namespace

struct SparseFactor::Factors {
  Eigen::SparseLU<singular::Matrix> lu, transposed;
};

SparseFactor::SparseFactor(std::unique_ptr<Factors> factors) : factors_(std::move(factors)) {}
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;
SparseFactor::~SparseFactor() = default;

std::optional<SparseFactor> SparseFactor::of(const SparseMatrix& A) {
  auto factors = std::make_unique<Factors>();
  singular::Matrix matrix = singular::eigen_matrix(A);
  stop_if_asked();
  factors->lu.compute(matrix);
  if (factors->lu.info() != Eigen::Success) return std::nullopt;
  matrix = singular::Matrix(matrix.transpose());
  factors->transposed.compute(matrix);
  if (factors->transposed.info() != Eigen::Success) return std::nullopt;
  return SparseFactor(std::move(factors));
}

namespace {

std::vector<double> solved(const Eigen::SparseLU<singular::Matrix>& lu, std::span<const double> b) {
  const Eigen::Map<const Eigen::VectorXd> right(b.data(), static_cast<Eigen::Index>(b.size()));
  const Eigen::VectorXd x = lu.solve(right);
  return {x.data(), x.data() + x.size()};
}

}  // namespace

std::vector<double> SparseFactor::solve(std::span<const double> b) const {
  return solved(factors_->lu, b);
}

std::vector<double> SparseFactor::solve_transposed(std::span<const double> b) const {
  return solved(factors_->transposed, b);
}

double guessed_singular_value(std::size_t n, const SparseFactor& factor) {
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = 1 + 0.5 * std::sin(static_cast<double>(i));
  x = singular::normalised(std::move(x));
  double growth = 0;
  for (int step = 0; step < 12; ++step) {
    stop_if_asked();
    const std::vector<double> y = factor.solve(factor.solve_transposed(x));
    growth = 0;
    for (const double v : y) growth = std::hypot(growth, v);
    if (!(growth > 0) || !std::isfinite(growth)) return 0;
    x = singular::normalised(y);
  }
  return 1 / std::sqrt(growth);
}

std::optional<singular::Shifted> singular::largest_shift(const SparseMatrix& A, const SparseFactor& factor) {
  const auto n = static_cast<double>(A.rows);
  const double guess = guessed_singular_value(A.rows, factor);
  if (!(guess > 0)) return std::nullopt;
  const WideMatrix lower = lower_square(A);
  double trace = 0;
  for (const double v : A.value) trace += v * v;
  trace *= 1 + 0x1p-20;  // far fewer than 2^30 terms
  // Products and Cholesky's method: each at most gamma_(n+2) trace; what underflows is far below.
  const double lost = 2 * (n + 8) * double_double_roundoff * 1.001 * trace + n * n * 0x1p-1000;
  for (double s = 0.7 * guess; s > 1e-3 * guess; s /= 4) {
    if (s * s <= 4 * lost) return std::nullopt;
    if (auto found = cholesky(lower, s * s)) return Shifted{s * s, lost, std::move(found)};
  }
  return std::nullopt;
}

std::optional<double> least_singular_value(const SparseMatrix& A, const SparseFactor& factor) {
  const auto found = singular::largest_shift(A, factor);
  if (!found) return std::nullopt;
  return std::sqrt(found->shift - found->lost) * (1 - 0x1p-50);
}

std::optional<SingularValueProof> prove_singular_value(const SparseMatrix& A, const SparseFactor& factor) {
  const auto found = singular::largest_shift(A, factor);
  if (!found) return std::nullopt;
  SingularValueProof result{std::sqrt(found->shift / 4) * (1 - 0x1p-50), 0, {}};
  std::vector<double> norms(A.columns, 0);
  for (std::size_t e = 0; e < A.entries(); ++e) norms[A.column[e]] += A.value[e] * A.value[e];
  const double norm = std::sqrt(*std::max_element(norms.begin(), norms.end()));
  result.grid = std::max(0, 4 + std::ilogb(static_cast<double>(A.rows) * norm / (result.value * result.value)));
  const auto& back = found->cholesky->permutationPinv().indices();
  for (Eigen::Index i = 0; i < found->cholesky->cols(); ++i) {
    result.order.push_back(static_cast<std::size_t>(back.size() > 0 ? back[i] : i));
  }
  return result;
}

}  // namespace slipproof
