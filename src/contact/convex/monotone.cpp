#include "contact/convex/monotone.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/number/binary64.hpp"
#include "contact/enclosure/sizes.hpp"
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
  std::vector<std::size_t> parent(B.rows);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::size_t i = 0; i < B.rows; ++i) {
    for (const std::uint32_t j : B.columns_of(i)) parent[root(i)] = root(j);
  }
  std::vector<std::size_t> part(B.rows);
  for (std::size_t i = 0; i < B.rows; ++i) part[i] = root(i);
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

/// A few operations on nonnegative numbers, rounded up.
double raised(double x) {
  return x == 0 ? 0 : x * (1 + 0x1p-45) + 0x1p-1060;
}

/// What a contact lacks to be complementary: r . u, and for what bounds its friction sum b |u_t|.
Rational gap_of(const MixedProblem& problem, std::size_t k, const std::vector<Rational>& r,
                const std::vector<Rational>& u) {
  Rational gap = 0;
  const std::size_t first = problem.normal(k), d = problem.dimension;
  for (std::size_t i = 0; i < d; ++i) {
    if (i > 0 && problem.law.kind == FrictionLaw::associated && problem.mu[k] == 0) break;
    gap += r[first + i] * u[first + i];
    if (i > 0 && problem.law.kind == FrictionLaw::fixed) {
      gap += to_rational(problem.law.bounds[(d - 1) * k + i - 1]) * abs(u[first + i]);
    }
  }
  return gap;
}

/// Whether u has a finite support on the forces of a contact: it is in the cone's dual.
bool is_dual(const MixedProblem& problem, std::size_t k, const std::vector<Rational>& u) {
  const std::size_t first = problem.normal(k);
  if (u[first].sign() < 0) return false;
  if (problem.law.kind != FrictionLaw::associated) return true;
  Rational square = 0;
  for (std::size_t i = 1; i < problem.dimension; ++i) square += u[first + i] * u[first + i];
  const Rational mu = to_rational(problem.mu[k]);
  return mu * mu * square <= u[first] * u[first];
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
  const std::vector<std::size_t> part = parts_of(B);
  std::vector<double> diagonal(B.rows, 0);
  std::vector<std::vector<std::size_t>> rows_of(B.rows);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < B.rows; ++i) {
    if (B.columns_of(i).empty()) continue;
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

namespace {

/// What an answer is fitted to, and the bounds that follow.
class Bound {
 public:
  Bound(const MixedProblem& problem, std::span<const double> answer, MonotoneProof proof)
      : problem_(problem), x_(answer.begin(), answer.end()) {
    result_.proof = std::move(proof);
  }

  std::optional<EverySolution> around(std::span<const double> start) {
    fit(start);
    if (!settle_rest()) return std::nullopt;
    if (!measure()) return std::nullopt;
    spread_out();
    return std::move(result_);
  }

 private:
  const Rational& modulus(std::size_t i) const { return result_.proof.moduli[i]; }

  void fit(std::span<const double> start) {
    const Residual r = residual(problem_, start, exact_rows(problem_, start));
    for (std::size_t i = 0; i < problem_.free; ++i) result_.point.push_back(to_rational(start[i]));
    result_.motion.assign(problem_.free, Rational(0));
    for (const FittedContact& c : r.contacts) {
      result_.point.insert(result_.point.end(), c.r.begin(), c.r.end());
      result_.motion.insert(result_.motion.end(), c.u.begin(), c.u.end());
    }
  }

  /// Velocities of contacts with d = 0 have to be those of the point. Where they leave the dual cone, a push along
  /// which all contacts open brings them back.
  bool settle_rest() {
    std::vector<std::size_t> loose;
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      for (std::size_t i = 0; i < problem_.dimension; ++i) {
        if (modulus(problem_.normal(k) + i).sign() > 0) continue;
        loose.push_back(k);
        break;
      }
    }
    for (std::size_t i = 0; i < problem_.free; ++i) {
      if (modulus(i).sign() == 0 && !exact_row(problem_, i, result_.point).is_zero()) return false;
    }
    if (loose.empty()) return true;
    const std::vector<double> push = opening_push(loose);
    for (double much = 0; much < 0x1p-10; much = much == 0 ? 0x1p-60 * size_of_free(push) : 4 * much) {
      std::vector<Rational> moved = result_.point;
      for (std::size_t j = 0; j < problem_.free; ++j) {
        if (modulus(j).sign() > 0) moved[j] = to_rational(nearest_binary64(moved[j] + to_rational(much * push[j])));
      }
      if (take_velocities(loose, moved)) {
        result_.point = std::move(moved);
        return true;
      }
      if (push.empty()) return false;
    }
    return false;
  }

  double size_of_free(const std::vector<double>& push) const {
    double size = 0, along = 0;
    for (std::size_t j = 0; j < problem_.free; ++j) {
      size = std::max(size, std::abs(x_[j]));
      along = std::max(along, push.empty() ? 0 : std::abs(push[j]));
    }
    return along > 0 && size > 0 ? size / along : 1;
  }

  bool take_velocities(const std::vector<std::size_t>& loose, const std::vector<Rational>& point) {
    for (const std::size_t k : loose) {
      for (std::size_t i = 0; i < problem_.dimension; ++i) {
        const std::size_t row = problem_.normal(k) + i;
        result_.motion[row] = exact_row(problem_, row, point);
      }
      if (!is_dual(problem_, k, result_.motion)) return false;
    }
    return true;
  }

  /// Free unknowns whose change moves all these contacts along their normals, in the least squares; empty if none does.
  std::vector<double> opening_push(const std::vector<std::size_t>& loose) const {
    if (problem_.free == 0 || problem_.free > 3000 || loose.size() > 3000) return {};
    const auto rows = static_cast<Eigen::Index>(loose.size() * problem_.dimension);
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(problem_.free));
    Eigen::VectorXd open = Eigen::VectorXd::Zero(rows);
    for (std::size_t k = 0; k < loose.size(); ++k) {
      for (std::size_t i = 0; i < problem_.dimension; ++i) {
        const std::size_t row = problem_.normal(loose[k]) + i;
        const auto at = static_cast<Eigen::Index>(k * problem_.dimension + i);
        open[at] = i == 0 ? 1 : 0;
        for (std::size_t e = problem_.A.starts[row]; e < problem_.A.starts[row + 1]; ++e) {
          if (problem_.A.column[e] < problem_.free) {
            H(at, static_cast<Eigen::Index>(problem_.A.column[e])) = problem_.A.value[e];
          }
        }
      }
    }
    const Eigen::VectorXd push = H.completeOrthogonalDecomposition().solve(open);
    if (!push.allFinite()) return {};
    return {push.data(), push.data() + push.size()};
  }

  /// Shares, gaps and the energy. Where a row has d = 0, nothing may be left.
  bool measure() {
    double squares = 0, gaps = 0;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const Rational rest = exact_row(problem_, i, result_.point) - result_.motion[i];
      double share = 0;
      if (modulus(i).sign() > 0) {
        share = raised(upper_size(rest) / std::sqrt(enclose(modulus(i)).lower));
      } else if (!rest.is_zero()) {
        return false;
      }
      result_.shares.push_back(share);
      squares += share * share;
    }
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      const Rational gap = gap_of(problem_, k, result_.point, result_.motion);
      result_.gaps.push_back(gap.sign() <= 0 ? 0 : raised(upper_size(gap)));
      gaps += result_.gaps.back();
    }
    squares = squares == 0 ? 0 : squares * (1 + 0x1p-30) + 0x1p-1000;  // far fewer than 2^20 sums
    gaps = gaps == 0 ? 0 : gaps * (1 + 0x1p-30) + 0x1p-1000;
    result_.energy = (std::sqrt(squares) + std::sqrt(squares + 4 * gaps)) / 2 * (1 + 0x1p-40);
    return std::isfinite(result_.energy);
  }

  void spread_out() {
    const double energy = result_.energy;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const bool bounded = modulus(i).sign() > 0;
      result_.radius.push_back(bounded ? raised(energy / std::sqrt(enclose(modulus(i)).lower))
                                       : std::numeric_limits<double>::infinity());
      if (bounded) {
        const Rational away = result_.point[i] - to_rational(x_[i]);
        result_.rho = std::max(result_.rho, raised(upper_size(away) + result_.radius[i]));
        result_.apart = std::max(result_.apart, (enclose(abs(away)).lower - result_.radius[i]) * (1 - 0x1p-50));
      } else if (i >= problem_.free) {
        ++result_.open;
      }
    }
    const bool symmetric = problem_.A == transposed(problem_.A);
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      double sum = 0, own = 0;
      for (std::size_t e = problem_.A.starts[i]; e < problem_.A.starts[i + 1]; ++e) {
        const std::size_t j = problem_.A.column[e];
        if (j == i) own = problem_.A.value[e];
        if (problem_.A.value[e] != 0) sum += std::abs(problem_.A.value[e]) * result_.radius[j];
      }
      sum = sum == 0 ? 0 : sum * (1 + 0x1p-30) + 0x1p-1000;
      if (symmetric) sum = std::min(sum, raised(std::sqrt(own) * energy));
      result_.changes.push_back(sum);
      if (i < problem_.free) continue;
      const Rational away = exact_row(problem_, i, result_.point) - exact_row(problem_, i, std::span<const double>(x_));
      result_.eta = std::max(result_.eta, raised(upper_size(away) + sum));
    }
  }

  const MixedProblem& problem_;
  const std::vector<double> x_;
  EverySolution result_;
};

}  // namespace

std::optional<EverySolution> every_solution(const MixedProblem& problem, std::span<const double> start,
                                            std::span<const double> answer, MonotoneProof proof) {
  return Bound(problem, answer, std::move(proof)).around(start);
}

double error_of(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                const EverySolution& solution) {
  std::vector<Around> components, velocities;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const bool bounded = std::isfinite(solution.radius[i]);
    components.push_back(bounded ? Around{solution.point[i], solution.radius[i]} : Around{to_rational(x[i]), 0});
    velocities.push_back({exact_row(problem, i, solution.point), solution.changes[i]});
  }
  return error_of(problem, x, u, components, velocities);
}

}  // namespace slipproof
