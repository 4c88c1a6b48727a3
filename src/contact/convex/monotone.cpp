#include "contact/convex/monotone.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/algebra/union_find.hpp"
#include "base/number/binary64.hpp"
#include "contact/linear/definite.hpp"

namespace slipproof {

namespace {

constexpr std::size_t largest_eigenproblem = 1500;

/// A without its antisymmetric part, as far as that cancels exactly: B + B^T = A + A^T.
SparseMatrix symmetric_part(const SparseMatrix& A) {
  const SparseMatrix other = transposed(A);
  SparseMatrix B;
  B.rows = B.columns = A.rows;
  for (std::size_t i = 0; i < A.rows; ++i) {
    const auto opposite = other.columns_of(i);
    for (std::size_t e = A.starts[i]; e < A.starts[i + 1]; ++e) {
      const auto found = std::lower_bound(opposite.begin(), opposite.end(), A.column[e]);
      const bool both = found != opposite.end() && *found == A.column[e];
      const double back = both ? other.values_of(i)[static_cast<std::size_t>(found - opposite.begin())] : 0;
      if (A.value[e] == 0 || (A.column[e] != i && A.value[e] == -back)) continue;
      B.column.push_back(A.column[e]);
      B.value.push_back(A.value[e]);
    }
    B.starts.push_back(B.value.size());
  }
  return B;
}

/// The connected parts of a matrix: of each row the number of its part.
std::vector<std::size_t> parts_of(const SparseMatrix& B) {
  UnionFind parts(B.rows);
  for (std::size_t i = 0; i < B.rows; ++i) {
    for (const std::uint32_t j : B.columns_of(i)) parts.join(i, j);
  }
  std::vector<std::size_t> part(B.rows);
  for (std::size_t i = 0; i < B.rows; ++i) part[i] = parts.find(i);
  return part;
}

/// Roughly the least eigenvalue of a part whose diagonal is scaled to 1; nothing where that is not clearly positive.
std::optional<double> least_eigenvalue(const SparseMatrix& B, const std::vector<std::size_t>& rows,
                                       std::span<const double> diagonal, Effort& effort) {
  const std::size_t n = rows.size();
  if (n == 1) return 1;
  if (n > largest_eigenproblem) return 0x1p-30;  // which Cholesky's method may confirm
  effort.spend(times(times(n, n), 10 * n));
  std::vector<Eigen::Index> place(B.rows, -1);
  for (std::size_t i = 0; i < n; ++i) place[rows[i]] = static_cast<Eigen::Index>(i);
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  for (const std::size_t i : rows) {
    for (std::size_t e = B.starts[i]; e < B.starts[i + 1]; ++e) {
      const std::size_t j = B.column[e];
      const double half = B.value[e] / std::sqrt(diagonal[i]) / std::sqrt(diagonal[j]) / 2;
      C(place[i], place[j]) += half;
      C(place[j], place[i]) += half;
    }
  }
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(C, Eigen::EigenvaluesOnly).eigenvalues()[0];
  if (!(least > 1e-14 * static_cast<double>(n))) return std::nullopt;
  return least;
}

/// Some of the rows and columns.
SparseMatrix restricted(const SparseMatrix& B, const std::vector<std::size_t>& rows) {
  std::vector<std::uint32_t> place(B.rows, 0);
  for (std::size_t i = 0; i < rows.size(); ++i) place[rows[i]] = static_cast<std::uint32_t>(i);
  SparseMatrix result;
  result.rows = result.columns = rows.size();
  for (const std::size_t i : rows) {
    for (std::size_t e = B.starts[i]; e < B.starts[i + 1]; ++e) {
      result.column.push_back(place[B.column[e]]);
      result.value.push_back(B.value[e]);
    }
    result.starts.push_back(result.value.size());
  }
  return result;
}

/// L of some rows, in its place among all.
SparseMatrix spread(const SparseMatrix& L, const std::vector<std::size_t>& rows, std::size_t size) {
  SparseMatrix result;
  result.rows = result.columns = size;
  for (std::size_t i = 0, k = 0; i < size; ++i) {
    if (k < rows.size() && rows[k] == i) {
      for (const std::uint32_t j : L.columns_of(k)) result.column.push_back(static_cast<std::uint32_t>(rows[j]));
      const auto values = L.values_of(k++);
      result.value.insert(result.value.end(), values.begin(), values.end());
    }
    result.starts.push_back(result.value.size());
  }
  return result;
}

}  // namespace

bool is_convex(const MixedProblem& problem) {
  using enum FrictionLaw;
  const bool law = problem.law.kind == associated || problem.law.kind == fixed;
  const auto smooth = [](double mu) { return mu == 0; };
  return law || problem.dimension == 1 || std::all_of(problem.mu.begin(), problem.mu.end(), smooth);
}

bool MonotoneProof::strict() const {
  return std::all_of(moduli.begin(), moduli.end(), [](const Rational& d) { return d.sign() > 0; });
}

std::optional<MonotoneProof> prove_monotone(const MixedProblem& problem, Effort& effort) {
  SparseMatrix B = symmetric_part(problem.A);
  const SparseMatrix across = transposed(B);
  const std::vector<std::size_t> part = parts_of(B);
  std::vector<double> diagonal(B.rows, 0);
  std::vector<std::vector<std::size_t>> rows_of(B.rows);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < B.rows; ++i) {
    if (B.columns_of(i).empty() && across.columns_of(i).empty()) continue;
    rows_of[part[i]].push_back(i);
    rows.push_back(i);
    for (std::size_t e = B.starts[i]; e < B.starts[i + 1]; ++e) diagonal[i] += B.column[e] == i ? B.value[e] : 0;
    if (!(diagonal[i] > 0)) return std::nullopt;
  }
  MonotoneProof proof;
  proof.moduli.assign(B.rows, Rational(0));
  for (const std::vector<std::size_t>& own : rows_of) {
    if (own.empty()) continue;
    const auto least = least_eigenvalue(B, own, diagonal, effort);
    if (!least) return std::nullopt;
    const double share = own.size() == 1 ? 1 - 0x1p-40 : *least * (1 - 0x1p-6);
    for (const std::size_t i : own) {
      for (std::size_t e = B.starts[i]; e < B.starts[i + 1]; ++e) {
        if (B.column[e] != i) continue;
        const double reduced = diagonal[i] * (1 - share);
        proof.moduli[i] = to_rational(B.value[e]) - to_rational(reduced);
        B.value[e] = reduced;
      }
      if (proof.moduli[i].sign() <= 0) return std::nullopt;
    }
  }
  const auto L = definite_factor(restricted(B, rows), effort);
  if (!L) return std::nullopt;
  proof.factor = spread(*L, rows, B.rows);
  return proof;
}

}  // namespace slipproof
