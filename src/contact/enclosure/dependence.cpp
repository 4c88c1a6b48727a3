#include "contact/enclosure/dependence.hpp"

#include <flint/nmod_mat.h>

#include <Eigen/OrderingMethods>
#include <Eigen/QR>
#include <Eigen/SparseQR>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/algebra/flint_matrix.hpp"
#include "base/algebra/sparse/sparse_basis.hpp"
#include "base/number/binary64.hpp"
#include "base/number/effort.hpp"
#include "base/parallel/stop.hpp"
#include "contact/enclosure/enclosure.hpp"

namespace slipproof {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Of exact rows, in proportion to their entries: round ones take far less.
constexpr Work least_elimination = 1'000'000, elimination_of_entry = 1'000;

MatrixXd derivative_of(const ModeSystem& system, std::span<const double> z, std::span<const std::size_t> equations,
                       std::span<const std::size_t> unknowns) {
  std::vector<Index> place(system.size(), -1);
  for (std::size_t j = 0; j < unknowns.size(); ++j) place[unknowns[j]] = static_cast<Index>(j);
  MatrixXd J = MatrixXd::Zero(static_cast<Index>(equations.size()), static_cast<Index>(unknowns.size()));
  for (std::size_t i = 0; i < equations.size(); ++i) {
    for (const auto& e : system.derivative(equations[i], z)) {
      if (place[e.unknown] >= 0) J(static_cast<Index>(i), place[e.unknown]) = e.value;
    }
  }
  return J;
}

/// The columns that pivoting takes first; each has its weight as its size before.
std::vector<Index> independent_columns(const MatrixXd& matrix, const std::vector<double>& weights) {
  if (matrix.size() == 0) return {};
  MatrixXd scaled = matrix;
  for (Index j = 0; j < scaled.cols(); ++j) {
    const double norm = scaled.col(j).norm();
    if (norm > 0) scaled.col(j) *= weights[static_cast<std::size_t>(j)] / norm;
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(scaled);
  qr.setThreshold(1e-10);
  const auto& order = qr.colsPermutation().indices();
  std::vector<Index> result(order.data(), order.data() + qr.rank());
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::size_t> others(const std::vector<Index>& chosen, std::span<const std::size_t> all) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!std::binary_search(chosen.begin(), chosen.end(), static_cast<Index>(i))) result.push_back(all[i]);
  }
  return result;
}

/// A matrix modulo a prime of 62 bits.
class ResidueMatrix {
 public:
  ResidueMatrix(std::size_t rows, std::size_t columns) {
    nmod_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns), prime);
  }
  explicit ResidueMatrix(FlintMatrix& matrix)
      : ResidueMatrix(static_cast<std::size_t>(fmpz_mat_nrows(matrix.get())),
                      static_cast<std::size_t>(fmpz_mat_ncols(matrix.get()))) {
    fmpz_mat_get_nmod_mat(value_, matrix.get());
  }
  ~ResidueMatrix() { nmod_mat_clear(value_); }
  ResidueMatrix(const ResidueMatrix&) = delete;
  ResidueMatrix& operator=(const ResidueMatrix&) = delete;

  nmod_mat_struct* get() { return value_; }

 private:
  static constexpr mp_limb_t prime = 4611686018427387847;  // the largest below 2^62

  nmod_mat_t value_;
};

/// Puts a linear equation, as a row of A with its constant below, into a column; without what is 0 in the mode.
void put_equation(FlintRationalMatrix& to, std::size_t column, const MixedProblem& problem, const ModeSystem& system,
                  std::size_t row) {
  const auto columns = problem.A.columns_of(row);
  for (std::size_t e = 0; e < columns.size(); ++e) {
    if (!system.is_zero(columns[e])) to.set(columns[e], column, to_rational(problem.A.values_of(row)[e]));
  }
  to.set(problem.size(), column, to_rational(problem.c[row]));
}

/// Whether A X = B has a solution modulo a prime. If it has none, it has none at all, or only some with denominators
/// that this prime divides, which nobody looks for; to find that out in rational numbers takes hundreds of primes.
bool may_have_solution(FlintRationalMatrix& A, FlintRationalMatrix& B) {
  const auto rows = static_cast<std::size_t>(fmpq_mat_nrows(A.get()));
  const auto unknowns = static_cast<std::size_t>(fmpq_mat_ncols(A.get()));
  const auto sides = static_cast<std::size_t>(fmpq_mat_ncols(B.get()));
  FlintMatrix whole_A(rows, unknowns), whole_B(rows, sides);
  fmpq_mat_get_fmpz_mat_rowwise_2(whole_A.get(), whole_B.get(), nullptr, A.get(), B.get());
  ResidueMatrix a(whole_A), b(whole_B), x(unknowns, sides);
  return nmod_mat_can_solve(x.get(), a.get(), b.get()) != 0;
}

/// The unknowns beside which the equations are regular, as well as can be; nothing if there are none.
std::optional<std::vector<std::size_t>> well_dependent_unknowns(const ModeSystem& system, std::span<const double> z,
                                                                std::span<const std::size_t> equations,
                                                                std::span<const std::size_t> unknowns) {
  const std::vector<double> weights(unknowns.size(), 1);
  const std::vector<Index> columns = independent_columns(derivative_of(system, z, equations, unknowns), weights);
  if (columns.size() != equations.size()) return std::nullopt;
  return others(columns, unknowns);
}

}  // namespace

DependentPart dependent_part(const ModeSystem& system, std::span<const double> z,
                             std::span<const std::size_t> equations, std::span<const std::size_t> unknowns) {
  const MatrixXd J = derivative_of(system, z, equations, unknowns);
  std::vector<double> weights;
  for (const std::size_t e : equations) {
    weights.push_back(system.equations()[e].kind == ModeSystem::Kind::linear ? 1 : 64);
  }
  const std::vector<Index> rows = independent_columns(J.transpose(), weights);
  MatrixXd kept(static_cast<Index>(rows.size()), J.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) kept.row(static_cast<Index>(i)) = J.row(rows[i]);
  const std::vector<Index> columns = independent_columns(kept, std::vector<double>(unknowns.size(), 1));
  return {others(rows, equations), others(columns, unknowns), rows.size() == columns.size()};
}

bool combine(const MixedProblem& problem, const ModeSystem& system, std::span<const std::size_t> equations,
             std::vector<DroppedEquation>& dropped) {
  std::vector<bool> kept(system.size(), true);
  for (const DroppedEquation& d : dropped) kept[d.equation] = false;
  std::vector<std::size_t> linear;
  for (const std::size_t e : equations) {
    if (kept[e] && system.equations()[e].kind == ModeSystem::Kind::linear) linear.push_back(e);
  }
  if (dropped.empty()) return true;
  FlintRationalMatrix A(problem.size() + 1, linear.size()), B(problem.size() + 1, dropped.size());
  for (std::size_t j = 0; j < linear.size(); ++j)
    put_equation(A, j, problem, system, system.equations()[linear[j]].row);
  for (std::size_t j = 0; j < dropped.size(); ++j) {
    const auto& equation = system.equations()[dropped[j].equation];
    if (equation.kind != ModeSystem::Kind::linear) return false;
    put_equation(B, j, problem, system, equation.row);
  }
  FlintRationalMatrix X(linear.size(), dropped.size());
  if (!may_have_solution(A, B) || fmpq_mat_can_solve(X.get(), A.get(), B.get()) == 0) return false;
  for (std::size_t j = 0; j < dropped.size(); ++j) {
    for (std::size_t i = 0; i < linear.size(); ++i) {
      if (Rational c = X.at(i, j); !c.is_zero()) dropped[j].combination.emplace_back(linear[i], std::move(c));
    }
  }
  return true;
}

namespace {

/// The linear equations as columns: a row for each component of x that is not 0 in the mode, the last for constants.
std::vector<SparseVector> linear_columns(const MixedProblem& problem, const ModeSystem& system,
                                         std::span<const std::size_t> linear) {
  std::vector<SparseVector> result;
  for (const std::size_t e : linear) {
    const std::size_t row = system.equations()[e].row;
    SparseVector& column = result.emplace_back();
    for (std::size_t i = problem.A.starts[row]; i < problem.A.starts[row + 1]; ++i) {
      const std::uint32_t place = problem.A.column[i];
      if (!system.is_zero(place)) column.emplace_back(place, to_rational(problem.A.value[i]));
    }
    if (problem.c[row] != 0) column.emplace_back(problem.size(), to_rational(problem.c[row]));
  }
  return result;
}

/// The linear equations that are combinations of the others, with these. Throws TooMuchWork.
std::vector<DroppedEquation> dropped_exactly(const MixedProblem& problem, const ModeSystem& system,
                                             std::span<const std::size_t> linear) {
  const std::vector<SparseVector> columns = linear_columns(problem, system, linear);
  Work entries = 0;
  for (const SparseVector& column : columns) entries += column.size();
  Effort effort(least_elimination + elimination_of_entry * entries);
  std::vector<const SparseVector*> all;
  for (const SparseVector& column : columns) all.push_back(&column);
  const SparseBasis whole(problem.size() + 1, all, effort);
  std::vector<bool> drops(linear.size(), false), free(problem.size() + 1, false);
  for (const std::size_t j : whole.dependent()) drops[j] = true;
  for (const std::size_t i : whole.free_rows()) free[i] = true;
  std::vector<std::uint32_t> place(problem.size() + 1, 0);
  std::uint32_t rows = 0;
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = free[i] ? 0 : rows++;
  const auto in_pivots = [&](const SparseVector& column) {
    SparseVector own;
    for (const auto& [i, value] : column) {
      if (!free[i]) own.emplace_back(place[i], value);
    }
    return own;
  };
  std::vector<std::size_t> kept;
  std::vector<SparseVector> square;
  for (std::size_t j = 0; j < linear.size(); ++j) {
    if (!drops[j]) kept.push_back(linear[j]), square.push_back(in_pivots(columns[j]));
  }
  all.clear();
  for (const SparseVector& column : square) all.push_back(&column);
  const SparseBasis basis(rows, all, effort);
  std::vector<DroppedEquation> result;
  for (const std::size_t j : whole.dependent()) {
    effort.spend(20 * Work(rows));
    std::vector<Rational> b(rows);
    for (const auto& [i, value] : in_pivots(columns[j])) b[i] = value;
    DroppedEquation& dropped = result.emplace_back(DroppedEquation{linear[j], {}});
    const std::vector<Rational> parts = basis.solve(std::move(b));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!parts[i].is_zero()) dropped.combination.emplace_back(kept[i], parts[i]);
    }
  }
  return result;
}

/// The unknowns beside which the equations are regular, by a sparse QR decomposition; nothing if there are none.
std::optional<std::vector<std::size_t>> dependent_unknowns(const ModeSystem& system, std::span<const double> z,
                                                           std::span<const std::size_t> equations,
                                                           std::span<const std::size_t> unknowns) {
  std::vector<int> place(system.size(), -1);
  for (std::size_t j = 0; j < unknowns.size(); ++j) place[unknowns[j]] = static_cast<int>(j);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < equations.size(); ++i) {
    for (const auto& e : system.derivative(equations[i], z)) {
      if (place[e.unknown] >= 0) entries.emplace_back(static_cast<int>(i), place[e.unknown], e.value);
    }
  }
  Eigen::SparseMatrix<double> J(static_cast<Index>(equations.size()), static_cast<Index>(unknowns.size()));
  J.setFromTriplets(entries.begin(), entries.end());
  for (Index j = 0; j < J.cols(); ++j) {
    const double norm = J.col(j).norm();
    if (norm > 0) J.col(j) *= 1 / norm;
  }
  stop_if_asked();
  Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> qr;
  qr.setPivotThreshold(1e-10);
  qr.compute(J);
  if (qr.info() != Eigen::Success || qr.rank() != J.rows()) return std::nullopt;
  std::vector<std::size_t> result;
  const auto& order = qr.colsPermutation().indices();
  for (Index j = qr.rank(); j < J.cols(); ++j) result.push_back(unknowns[static_cast<std::size_t>(order[j])]);
  std::sort(result.begin(), result.end());
  return result;
}

/// Whether equations have few unknowns each, so that an elimination fills in little.
bool is_sparse(const ModeSystem& system, std::span<const double> z, std::span<const std::size_t> equations) {
  std::size_t entries = 0;
  for (const std::size_t e : equations) entries += system.derivative(e, z).size();
  return entries <= 20 * equations.size();
}

/// exact_dependence() for a large or sparse block: exactly dependent equations first.
DependenceResult sparse_dependence(const MixedProblem& problem, const ModeSystem& system, std::span<const double> z,
                                   std::span<const std::size_t> equations, std::span<const std::size_t> unknowns) {
  DependenceResult result;
  std::vector<std::size_t> linear;
  for (const std::size_t e : equations) {
    if (system.equations()[e].kind == ModeSystem::Kind::linear) linear.push_back(e);
  }
  try {
    result.dropped = dropped_exactly(problem, system, linear);
  } catch (const TooMuchWork&) {
    result.unknowns.assign(unknowns.begin(), unknowns.end());
    result.reason =
        "equations depend on each other, and to find out which exactly is too much work where contacts "
        "have no round coordinates";
    return result;
  }
  std::vector<bool> drops(system.size(), false);
  for (const DroppedEquation& d : result.dropped) drops[d.equation] = true;
  std::vector<std::size_t> kept;
  for (const std::size_t e : equations) {
    if (!drops[e]) kept.push_back(e);
  }
  auto open = std::max(kept.size(), unknowns.size()) > largest_dependent
                  ? dependent_unknowns(system, z, kept, unknowns)
                  : well_dependent_unknowns(system, z, kept, unknowns);
  if (open && !open->empty()) {
    result.unknowns = std::move(*open);
    return result;
  }
  result.unknowns.assign(unknowns.begin(), unknowns.end());
  result.reason = "the forces of these contacts depend on each other, not exactly, but up to rounding";
  return result;
}

}  // namespace

DependenceResult exact_dependence(const MixedProblem& problem, const ModeSystem& system, std::span<const double> z,
                                  std::span<const std::size_t> equations, std::span<const std::size_t> unknowns) {
  const bool large = std::max(equations.size(), unknowns.size()) > largest_dependent;
  if (large || is_sparse(system, z, equations)) {
    DependenceResult result = sparse_dependence(problem, system, z, equations, unknowns);
    if (large || result.reason.empty()) return result;
  }
  DependenceResult result;
  DependentPart part = dependent_part(system, z, equations, unknowns);
  result.unknowns = std::move(part.unknowns);
  for (const std::size_t i : part.equations) result.dropped.push_back({i, {}});
  if (!part.regular || (result.dropped.empty() && result.unknowns.empty())) {
    result.reason = "the equations of these contacts are too close to dependent for binary64";
  } else if (!combine(problem, system, equations, result.dropped)) {
    result.reason = "the forces of these contacts depend on each other, not exactly, but up to rounding";
  }
  return result;
}

}  // namespace slipproof
