#include "contact/problem/mixed_problem.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/algebra/flint_matrix.hpp"
#include "base/number/binary64.hpp"
#include "contact/problem/parts.hpp"

namespace slipproof {

namespace {

/// Puts a matrix with a sign at a place of a larger one.
void put(std::vector<MatrixEntry>& entries, const SparseMatrix& m, std::size_t row, std::size_t column, double sign) {
  for (std::size_t i = 0; i < m.rows; ++i) {
    for (std::size_t k = m.starts[i]; k < m.starts[i + 1]; ++k) {
      entries.push_back(
          {static_cast<std::uint32_t>(row + i), static_cast<std::uint32_t>(column + m.column[k]), sign * m.value[k]});
    }
  }
}

void append(std::vector<double>& to, const std::vector<double>& values, double sign, std::size_t size) {
  for (const double x : values) to.push_back(sign * x);
  to.resize(to.size() + size - values.size(), 0);  // what the file leaves out is 0
}

/// From row `first` on.
void add_to_diagonal(std::vector<MatrixEntry>& entries, std::size_t first, const std::vector<double>& values) {
  std::vector<double> left = values;
  for (MatrixEntry& e : entries) {
    if (e.row != e.column || e.row < first || e.row - first >= left.size()) continue;
    e.value += left[e.row - first];
    left[e.row - first] = 0;
  }
  for (std::size_t i = 0; i < left.size(); ++i) {
    const auto place = static_cast<std::uint32_t>(first + i);
    if (left[i] != 0) entries.push_back({place, place, left[i]});
  }
}

/// The rows of X and y of free unknowns that depend on no others. False if their equations are singular.
bool solve_free(const MixedProblem& problem, const std::vector<std::size_t>& part, EliminatedProblem& result) {
  std::vector<std::size_t> forces;  // on which they depend
  for (const std::size_t row : part) {
    for (const std::uint32_t j : problem.A.columns_of(row)) {
      if (j >= problem.free) forces.push_back(j);
    }
  }
  std::ranges::sort(forces);
  forces.erase(std::unique(forces.begin(), forces.end()), forces.end());
  const auto place = [](const std::vector<std::size_t>& of, std::size_t j) {
    return static_cast<std::size_t>(std::ranges::lower_bound(of, j) - of.begin());
  };
  FlintRationalMatrix A(part.size(), part.size()), right(part.size(), forces.size() + 1),
      solved(part.size(), forces.size() + 1);
  for (std::size_t i = 0; i < part.size(); ++i) {
    right.set(i, forces.size(), -to_rational(problem.c[part[i]]));
    const auto columns = problem.A.columns_of(part[i]);
    for (std::size_t e = 0; e < columns.size(); ++e) {
      const std::size_t j = columns[e];
      const Rational a = to_rational(problem.A.values_of(part[i])[e]);
      j < problem.free ? A.set(i, place(part, j), a) : right.set(i, place(forces, j), -a);
    }
  }
  if (fmpq_mat_solve(solved.get(), A.get(), right.get()) == 0) return false;
  for (std::size_t i = 0; i < part.size(); ++i) {
    for (std::size_t j = 0; j < forces.size(); ++j) result.X[part[i]][forces[j] - problem.free] = solved.at(i, j);
    result.y[part[i]] = solved.at(i, forces.size());
  }
  return true;
}

}  // namespace

MixedProblem mixed_problem(const ProblemFile& file) {
  MixedProblem result;
  const std::size_t components = file.components();
  std::vector<MatrixEntry> entries, twice;
  if (file.form == ProblemForm::global) {
    const std::size_t bodies = file.M.rows, bilateral = file.G.columns;
    result.free = bodies + bilateral;
    put(entries, file.M, 0, 0, 1);
    put(entries, file.G, 0, bodies, -1);
    put(entries, file.H, 0, result.free, -1);
    put(entries, transposed(file.G), bodies, 0, 1);
    put(entries, transposed(file.H), result.free, 0, 1);
    append(result.c, file.f, -1, bodies);
    append(result.c, file.b, 1, bilateral);
    append(result.c, file.w, 1, components);
  } else {
    result.free = file.V.columns;
    put(entries, file.R, 0, 0, 1);
    put(entries, transposed(file.V), 0, result.free, 1);
    put(entries, file.V, result.free, 0, 1);
    put(entries, file.W, result.free, result.free, 1);
    append(result.c, file.s, 1, result.free);
    append(result.c, file.q, 1, components);
  }
  add_to_diagonal(entries, result.free, file.compliance);
  for (std::size_t i = 0; i < file.bias.size(); ++i) result.c[result.free + i] += file.bias[i];
  if (file.impact) {
    const std::vector<Rational> restored = restored_velocities(file);
    for (std::size_t i = 0; i < components; ++i) result.c[result.free + i] += nearest_binary64(restored[i]);
  }
  result.law = file.law;
  result.dimension = file.dimension;
  const std::size_t n = result.free + components;
  result.A = sparse_matrix(n, n, std::move(entries), twice);
  result.mu = file.mu;
  result.mu.resize(file.contacts(), 0);
  return result;
}

MixedProblem coulomb_problem(ProblemFile file) {
  file.law = {};
  file.compliance.clear();
  file.bias.clear();
  return mixed_problem(file);
}

std::optional<EliminatedProblem> eliminated(const MixedProblem& problem) {
  const std::size_t free = problem.free, n = problem.size() - free;
  EliminatedProblem result;
  result.X.assign(free, std::vector<Rational>(n));
  result.y.resize(free);
  for (const std::vector<std::size_t>& part : free_parts(problem)) {
    if (!solve_free(problem, part, result)) return std::nullopt;
  }
  ContactProblem& small = result.problem;
  small.W.assign(n, std::vector<Rational>(n));
  for (std::size_t i = 0; i < n; ++i) {
    small.q.push_back(to_rational(problem.c[free + i]));
    const auto columns = problem.A.columns_of(free + i);
    for (std::size_t e = 0; e < columns.size(); ++e) {
      const std::size_t j = columns[e];
      const Rational a = to_rational(problem.A.values_of(free + i)[e]);
      if (j >= free) {
        small.W[i][j - free] += a;
        continue;
      }
      for (std::size_t k = 0; k < n; ++k) {
        if (!result.X[j][k].is_zero()) small.W[i][k] += a * result.X[j][k];
      }
      small.q[i] += a * result.y[j];
    }
  }
  if (problem.dimension == 2) small.mu = to_rationals(problem.mu);
  return result;
}

ContactProblem contact_problem(const MixedProblem& problem) {
  return std::move(eliminated(problem)->problem);
}

std::vector<Rational> EliminatedProblem::with_free(std::vector<Rational> r) const {
  std::vector<Rational> x = y;
  for (std::size_t j = 0; j < x.size(); ++j) {
    for (std::size_t k = 0; k < r.size(); ++k) x[j] += X[j][k] * r[k];
  }
  std::move(r.begin(), r.end(), std::back_inserter(x));
  return x;
}

ExactSum row_sum(const MixedProblem& problem, std::size_t row, std::span<const double> x) {
  ExactSum sum;
  sum.add(problem.c[row]);
  const auto columns = problem.A.columns_of(row);
  const auto values = problem.A.values_of(row);
  for (std::size_t k = 0; k < columns.size(); ++k) sum.add(values[k], x[columns[k]]);
  return sum;
}

Rational exact_row(const MixedProblem& problem, std::size_t row, std::span<const double> x) {
  return row_sum(problem, row, x).value();
}

Rational exact_row(const MixedProblem& problem, std::size_t row, const std::vector<Rational>& x) {
  Rational sum = to_rational(problem.c[row]);
  for (std::size_t e = problem.A.starts[row]; e < problem.A.starts[row + 1]; ++e) {
    sum += to_rational(problem.A.value[e]) * x[problem.A.column[e]];
  }
  return sum;
}

std::vector<Rational> exact_rows(const MixedProblem& problem, std::span<const double> x) {
  std::vector<Rational> w;
  w.reserve(problem.size());
  for (std::size_t i = 0; i < problem.size(); ++i) w.push_back(exact_row(problem, i, x));
  return w;
}

}  // namespace slipproof
