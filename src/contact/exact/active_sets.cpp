#include "contact/exact/active_sets.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace slipproof {

namespace {

using Eigen::Index;

Eigen::MatrixXd full_matrix(const SparseMatrix& A) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(static_cast<Index>(A.rows), static_cast<Index>(A.columns));
  for (std::size_t i = 0; i < A.rows; ++i) {
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) {
      result(static_cast<Index>(i), static_cast<Index>(A.column[k])) = A.value[k];
    }
  }
  return result;
}

/// The view of a set that principal pivoting uses: which components have the wrong sign, x_i < 0 or w_i < 0.
class PivotView {
 public:
  explicit PivotView(const MixedProblem& problem)
      : A_(full_matrix(problem.A)), c_(Eigen::Map<const Eigen::VectorXd>(problem.c.data(), A_.rows())) {}

  /// Nothing if the system looks singular in floating point.
  std::optional<std::vector<std::size_t>> wrong(const std::vector<bool>& active, Effort& effort) const {
    std::vector<Index> in, out;
    for (std::size_t i = 0; i < active.size(); ++i) (active[i] ? in : out).push_back(static_cast<Index>(i));
    effort.spend(plus(times(in.size() * in.size(), in.size() / 2 + 1), times(active.size(), active.size())));
    const Eigen::VectorXd x = A_(in, in).partialPivLu().solve(-c_(in));
    if (!x.allFinite()) return std::nullopt;
    const Eigen::MatrixXd rows = A_(out, in);
    const Eigen::VectorXd w = rows * x + c_(out);
    const Eigen::VectorXd size = rows.cwiseAbs() * x.cwiseAbs() + c_(out).cwiseAbs();
    std::vector<std::size_t> result;
    const double largest = x.size() == 0 ? 0 : x.cwiseAbs().maxCoeff();
    for (std::size_t k = 0; k < in.size(); ++k) {
      if (x[static_cast<Index>(k)] < -tiny * largest) result.push_back(static_cast<std::size_t>(in[k]));
    }
    for (std::size_t k = 0; k < out.size(); ++k) {
      const auto at = static_cast<Index>(k);
      if (w[at] < -tiny * size[at]) result.push_back(static_cast<std::size_t>(out[k]));
    }
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  static constexpr double tiny = 0x1p-44;  ///< what is a 0 with roundings: exact signs decide there
  Eigen::MatrixXd A_;
  Eigen::VectorXd c_;
};

/// Lemke's tableau: w - A x - e x_0 = c, solved for a basis. Columns are w, x, x_0 and the constant.
class LemkeTableau {
 public:
  explicit LemkeTableau(const MixedProblem& problem)
      : n_(static_cast<Index>(problem.size())), table_(n_, 2 * n_ + 2), basis_(problem.size()) {
    table_.leftCols(n_).setIdentity();
    table_.middleCols(n_, n_) = -full_matrix(problem.A);
    table_.col(cover()).setConstant(-1);
    table_.col(2 * n_ + 1) = Eigen::Map<const Eigen::VectorXd>(problem.c.data(), n_);
    for (Index i = 0; i < n_; ++i) basis_[static_cast<std::size_t>(i)] = i;
  }

  std::optional<std::vector<bool>> follow(Effort& effort) {
    Index row = 0;
    if (table_.col(2 * n_ + 1).minCoeff(&row) >= 0) return active();
    Index entering = cover();
    for (Index pivots = 0; pivots < 50 * n_ + 100; ++pivots) {
      effort.spend(static_cast<Work>(n_ * n_) * 2);
      const Index left = basis_[static_cast<std::size_t>(row)];
      pivot(row, entering);
      if (left == cover()) return active();
      entering = left < n_ ? left + n_ : left - n_;  // the complement of what left
      const auto next = leaving(entering);
      if (!next) return std::nullopt;  // a ray
      row = *next;
    }
    return std::nullopt;
  }

 private:
  Index cover() const { return 2 * n_; }

  void pivot(Index row, Index column) {
    const double value = table_(row, column);
    table_.row(row) /= value;
    Eigen::VectorXd factors = table_.col(column);
    factors[row] = 0;
    const Eigen::RowVectorXd pivot_row = table_.row(row);
    table_.noalias() -= factors * pivot_row;
    basis_[static_cast<std::size_t>(row)] = column;
  }

  /// The row that holds the column first; where several do, that of x_0, or else the one with the largest pivot.
  std::optional<Index> leaving(Index column) const {
    constexpr double small = 1e-11, same = 1e-12;
    const double size = table_.col(column).cwiseAbs().maxCoeff();
    const auto ratio = [&](Index i) { return std::max(table_(i, 2 * n_ + 1), 0.0) / table_(i, column); };
    std::vector<Index> rows;
    double least = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < n_; ++i) {
      if (!(table_(i, column) > small * size)) continue;
      rows.push_back(i);
      least = std::min(least, ratio(i));
    }
    std::optional<Index> best;
    for (const Index i : rows) {
      if (ratio(i) > least * (1 + same)) continue;
      if (basis_[static_cast<std::size_t>(i)] == cover()) return i;
      if (!best || table_(i, column) > table_(*best, column)) best = i;
    }
    return best;
  }

  std::vector<bool> active() const {
    std::vector<bool> result(basis_.size());
    for (const Index b : basis_) {
      if (b >= n_ && b < cover()) result[static_cast<std::size_t>(b - n_)] = true;
    }
    return result;
  }

  Index n_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> table_;
  std::vector<Index> basis_;
};

}  // namespace

std::optional<std::vector<bool>> active_by_pivots(const MixedProblem& problem, std::vector<bool> active,
                                                  Effort& effort) {
  constexpr std::size_t patience = 8;
  const std::size_t most_rounds = 100 + 4 * problem.size();
  const PivotView view(problem);
  std::size_t fewest = problem.size() + 1, in_vain = 0;
  for (std::size_t round = 0; round < most_rounds; ++round) {
    const auto wrong = view.wrong(active, effort);
    if (!wrong) return std::nullopt;
    if (wrong->empty()) return active;
    in_vain = wrong->size() < fewest ? 0 : in_vain + 1;
    fewest = std::min(fewest, wrong->size());
    if (in_vain > patience) {
      active[wrong->back()].flip();
    } else {
      for (const std::size_t i : *wrong) active[i].flip();
    }
  }
  return std::nullopt;
}

std::optional<std::vector<bool>> active_by_lemke(const MixedProblem& problem, Effort& effort) {
  return LemkeTableau(problem).follow(effort);
}

}  // namespace slipproof
