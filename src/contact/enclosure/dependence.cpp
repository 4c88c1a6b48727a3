#include "contact/enclosure/dependence.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "base/algebra/flint_matrix.hpp"
#include "base/number/binary64.hpp"
#include "contact/enclosure/enclosure.hpp"

namespace slipproof {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

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

/// Puts a linear equation, as a row of A with its constant below, into a column; without what is 0 in the mode.
void put_equation(FlintRationalMatrix& to, std::size_t column, const MixedProblem& problem, const ModeSystem& system,
                  std::size_t row) {
  const auto columns = problem.A.columns_of(row);
  for (std::size_t e = 0; e < columns.size(); ++e) {
    if (!system.is_zero(columns[e])) to.set(columns[e], column, to_rational(problem.A.values_of(row)[e]));
  }
  to.set(problem.size(), column, to_rational(problem.c[row]));
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
  FlintRationalMatrix X(linear.size(), dropped.size());
  for (std::size_t j = 0; j < linear.size(); ++j)
    put_equation(A, j, problem, system, system.equations()[linear[j]].row);
  for (std::size_t j = 0; j < dropped.size(); ++j) {
    const auto& equation = system.equations()[dropped[j].equation];
    if (equation.kind != ModeSystem::Kind::linear) return false;
    put_equation(B, j, problem, system, equation.row);
  }
  if (fmpq_mat_can_solve(X.get(), A.get(), B.get()) == 0) return false;
  for (std::size_t j = 0; j < dropped.size(); ++j) {
    for (std::size_t i = 0; i < linear.size(); ++i) {
      if (Rational c = X.at(i, j); !c.is_zero()) dropped[j].combination.emplace_back(linear[i], std::move(c));
    }
  }
  return true;
}

DependenceResult exact_dependence(const MixedProblem& problem, const ModeSystem& system, std::span<const double> z,
                                  std::span<const std::size_t> equations, std::span<const std::size_t> unknowns) {
  DependenceResult result;
  if (std::max(equations.size(), unknowns.size()) > largest_dependent) {
    result.reason = "equations depend on each other, and there are too many of them to find out which exactly";
    result.unknowns.assign(unknowns.begin(), unknowns.end());
    return result;
  }
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
