#include "contact/linear/definite.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/parallel/stop.hpp"
#include "base/rounding/exact_sum.hpp"

namespace slipproof {

namespace {

/// The rows of a matrix, and those of its transposed one.
struct BothWays {
  explicit BothWays(const SparseMatrix& rows) : rows(rows), columns(transposed(rows)) {}
  const SparseMatrix& rows;
  const SparseMatrix columns;
};

/// Row i of L, spread out to be multiplied with other rows.
class SpreadRow {
 public:
  explicit SpreadRow(const SparseMatrix& L) : L_(L), value_(L.columns) {}
  void spread(std::size_t i) {
    for (const std::uint32_t k : columns_) value_[k] = 0;
    const auto columns = L_.columns_of(i);
    columns_.assign(columns.begin(), columns.end());
    for (std::size_t k = 0; k < columns.size(); ++k) value_[columns[k]] = L_.values_of(i)[k];
  }
  double operator[](std::size_t k) const { return value_[k]; }

 private:
  const SparseMatrix& L_;
  std::vector<double> value_;
  std::vector<std::uint32_t> columns_;
};

/// Entries of A + A^T - L L^T as intervals.
///
/// A sum of m + 2 numbers, m of which are products, has an error of at most gamma (|a_ij| + |a_ji| + sum |l_ik l_jk|)
/// with gamma = (m + 2) e / (1 - (m + 2) e), in any order (Higham 2002, section 3.1), and 2^-1074 more for each product
/// that underflows; e = 2^-52 holds for every direction of rounding. The last sum is at most |l_i| |l_j| (Cauchy,
/// Schwarz). Bounds are sums of numbers >= 0 themselves: `paid` makes up for their own roundings with up to 2^20 rows.
class RoundedEntries {
 public:
  using Number = double;
  static constexpr std::size_t most_rows = std::size_t{1} << 20U;
  static constexpr double paid = 1 + 0x1p-28;

  explicit RoundedEntries(const SparseMatrix& L) : L_(L), row_(L) {
    for (std::size_t i = 0; i < L.rows; ++i) {
      double squares = 0;
      for (const double x : L.values_of(i)) squares += x * x;
      norm_.push_back(std::sqrt(squares) * paid + 0x1p-500);  // the latter for squares that underflow
    }
  }
  void begin_row(std::size_t i) {
    row_.spread(i);
    i_ = i;
  }
  /// A value, and how far it is off at most.
  std::pair<double, double> entry(std::size_t j, double a, double b) const {
    const auto columns = L_.columns_of(j);
    const auto values = L_.values_of(j);
    double sum = a + b;
    for (std::size_t k = 0; k < columns.size(); ++k) sum -= row_[columns[k]] * values[k];
    const auto terms = static_cast<double>(columns.size() + 2);
    const double gamma = terms * 0x1p-52 * paid;
    return {sum, (gamma * (std::abs(a) + std::abs(b) + norm_[i_] * norm_[j]) + terms * 0x1p-1060) * paid};
  }
  /// Also false where anything overflowed.
  static bool greater(double diagonal, double others) { return diagonal > others * paid; }

 private:
  const SparseMatrix& L_;
  SpreadRow row_;
  std::vector<double> norm_;
  std::size_t i_ = 0;
};

/// The same without rounding.
class ExactEntries {
 public:
  using Number = Rational;
  explicit ExactEntries(const SparseMatrix& L) : L_(L), row_(L) {}
  void begin_row(std::size_t i) { row_.spread(i); }
  std::pair<Rational, Rational> entry(std::size_t j, double a, double b) const {
    const auto columns = L_.columns_of(j);
    const auto values = L_.values_of(j);
    ExactSum sum;
    sum.add(a);
    sum.add(b);
    for (std::size_t k = 0; k < columns.size(); ++k) sum.add(-row_[columns[k]], values[k]);
    return {sum.value(), 0};
  }
  static bool greater(const Rational& diagonal, const Rational& others) { return diagonal > others; }

 private:
  const SparseMatrix& L_;
  SpreadRow row_;
};

/// Row i of A + A^T up to the diagonal, and where L L^T may have entries there, too.
class SymmetricRow {
 public:
  SymmetricRow(const BothWays& A, const BothWays& L)
      : A_(A), L_(L), from_row_(A.rows.rows), from_column_(A.rows.rows), seen_(A.rows.rows) {}
  const std::vector<std::size_t>& go_to(std::size_t i) {
    for (const std::size_t j : places_) {
      from_row_[j] = from_column_[j] = 0;
      seen_[j] = 0;
    }
    places_.clear();
    mark(i, i);
    take(A_.rows, i, from_row_);
    take(A_.columns, i, from_column_);
    for (const std::uint32_t k : L_.rows.columns_of(i)) {
      for (const std::uint32_t j : L_.columns.columns_of(k)) mark(j, i);
    }
    return places_;
  }
  double in_row(std::size_t j) const { return from_row_[j]; }
  double in_column(std::size_t j) const { return from_column_[j]; }

 private:
  void mark(std::size_t j, std::size_t i) {
    if (j > i || seen_[j] != 0) return;
    seen_[j] = 1;
    places_.push_back(j);
  }
  void take(const SparseMatrix& m, std::size_t i, std::vector<double>& to) {
    const auto columns = m.columns_of(i);
    for (std::size_t k = 0; k < columns.size() && columns[k] <= i; ++k) {
      mark(columns[k], i);
      to[columns[k]] = m.values_of(i)[k];
    }
  }

  const BothWays &A_, &L_;
  std::vector<double> from_row_, from_column_;
  std::vector<char> seen_;
  std::vector<std::size_t> places_;
};

template <class Entries>
bool rest_is_dominant(const BothWays& A, const BothWays& L) {
  const std::size_t n = A.rows.rows;
  std::vector<typename Entries::Number> diagonal(n), others(n);
  SymmetricRow row(A, L);
  Entries entries(L.rows);
  for (std::size_t i = 0; i < n; ++i) {
    stop_if_asked();
    entries.begin_row(i);
    for (const std::size_t j : row.go_to(i)) {
      const auto [value, error] = entries.entry(j, row.in_row(j), row.in_column(j));
      if (j == i) {
        diagonal[i] = value;
        others[i] += error;
      } else {
        using std::abs;
        const auto size = abs(value) + error;
        others[i] += size;
        others[j] += size;
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!Entries::greater(diagonal[i], others[i])) return false;
  }
  return true;
}

bool is_lower(const SparseMatrix& L) {
  for (std::size_t i = 0; i < L.rows; ++i) {
    for (const std::uint32_t j : L.columns_of(i)) {
      if (j > i) return false;
    }
  }
  return std::all_of(L.value.begin(), L.value.end(), [](double x) { return std::isfinite(x); });
}

/// Which entries between the first of each row and its diagonal Cholesky's elimination uses.
struct EliminationWork {
  Work work = 0;
  std::size_t widest = 0;  ///< row
};

EliminationWork elimination_work(const BothWays& A) {
  EliminationWork result;
  for (std::size_t i = 0; i < A.rows.rows; ++i) {
    std::size_t first = i;
    for (const SparseMatrix* m : {&A.rows, &A.columns}) {
      if (!m->columns_of(i).empty()) first = std::min<std::size_t>(first, m->columns_of(i).front());
    }
    result.work = plus(result.work, times(i - first + 1, i - first + 10));
    result.widest = std::max(result.widest, i - first + 1);
  }
  return result;
}

using LowerMatrix = Eigen::SparseMatrix<double>;

/// The lower half of A + A^T, less a part of each diagonal entry.
LowerMatrix shifted_sum(const SparseMatrix& A, const std::vector<double>& shift) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < A.rows; ++i) {
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) {
      const auto r = static_cast<int>(std::max<std::size_t>(i, A.column[k]));
      const auto c = static_cast<int>(std::min<std::size_t>(i, A.column[k]));
      entries.emplace_back(r, c, r == c ? 2 * A.value[k] - shift[i] : A.value[k]);
    }
  }
  const auto n = static_cast<Eigen::Index>(A.rows);
  LowerMatrix result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

std::optional<SparseMatrix> cholesky(const LowerMatrix& sum) {
  const Eigen::SimplicialLLT<LowerMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> llt(sum);
  if (llt.info() != Eigen::Success) return std::nullopt;
  const LowerMatrix L = llt.matrixL();
  SparseMatrix columns;
  columns.rows = columns.columns = static_cast<std::size_t>(L.cols());
  for (Eigen::Index j = 0; j < L.cols(); ++j) {
    for (LowerMatrix::InnerIterator it(L, j); it; ++it) {
      columns.column.push_back(static_cast<std::uint32_t>(it.row()));
      columns.value.push_back(it.value());
    }
    columns.starts.push_back(columns.value.size());
  }
  return transposed(columns);
}

/// What the diagonal gives up so that it dominates what rounding leaves in its row: `units` of the last place of
/// sqrt(s_ii s_jj) for each j.
std::vector<double> shift_of(const SparseMatrix& A, double units) {
  std::vector<double> result(A.rows);
  double sum = 0;
  for (std::size_t i = 0; i < A.rows; ++i) {
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) {
      if (A.column[k] == i) result[i] = std::sqrt(2 * A.value[k]);
    }
    sum += result[i];
  }
  for (double& x : result) x *= units * 0x1p-52 * sum;
  return result;
}

bool surely_dominant(const BothWays& A, const BothWays& L) {
  return L.rows.rows <= RoundedEntries::most_rows && rest_is_dominant<RoundedEntries>(A, L);
}

}  // namespace

bool is_definite(const SparseMatrix& A, const SparseMatrix& L) {
  if (A.rows != A.columns || L.rows != A.rows || L.columns != A.rows || !is_lower(L)) return false;
  const BothWays a(A), l(L);
  return surely_dominant(a, l) || rest_is_dominant<ExactEntries>(a, l);
}

std::optional<SparseMatrix> definite_factor(const SparseMatrix& A, Effort& effort) {
  constexpr Work sums_a_product = 2, exact_sums = 40;
  const BothWays a(A);
  const auto [work, widest] = elimination_work(a);
  const double terms = static_cast<double>(widest) + 2;
  effort.spend(times(work, 1 + sums_a_product));
  // Enough for the bounds of rounding errors, which grow with the number of terms.
  if (auto L = cholesky(shifted_sum(A, shift_of(A, 3 * terms)))) {
    if (surely_dominant(a, BothWays(*L))) return L;
  }
  // Enough for the errors themselves, where the matrix is nearly singular: they cancel for the most part.
  effort.spend(work);
  auto L = cholesky(shifted_sum(A, shift_of(A, std::sqrt(terms) / 4)));
  if (!L) return std::nullopt;
  effort.spend(times(work, exact_sums));
  if (!rest_is_dominant<ExactEntries>(a, BothWays(*L))) return std::nullopt;
  return L;
}

}  // namespace slipproof
