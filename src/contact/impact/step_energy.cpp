#include "contact/impact/step_energy.hpp"

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

/// Row i of A x, or of its transpose.
std::vector<Rational> product(const SparseMatrix& A, std::span<const Rational> x, bool transpose) {
  std::vector<Rational> result(transpose ? A.columns : A.rows);
  for (std::size_t i = 0; i < A.rows; ++i) {
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) {
      const std::size_t j = A.column[k];
      result[transpose ? j : i] += to_rational(A.value[k]) * x[transpose ? i : j];
    }
  }
  return result;
}

void add(std::vector<Rational>& to, const std::vector<Rational>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) to[i] += values[i];
}

/// The sum of the velocities of contacts before and after.
std::vector<Rational> twice_the_mean(const ProblemFile& problem, std::span<const Rational> x) {
  std::vector<Rational> before = to_rationals(problem.impact->before);
  if (problem.form == ProblemForm::global) {
    for (std::size_t i = 0; i < before.size(); ++i) before[i] += x[i];
    return product(problem.H, before, true);
  }
  add(before, to_rationals(problem.q));
  add(before, product(problem.W, x.last(problem.q.size()), false));
  if (problem.V.columns > 0) add(before, product(problem.V, x.first(problem.V.columns), false));
  return before;
}

}  // namespace

std::optional<bool> StepEnergy::gains(double tolerance) const {
  const Rational least = to_rational(tolerance) * (before && !before->is_zero() ? *before : size);
  if (abs(work) <= least) return std::nullopt;
  return work.sign() > 0;
}

StepEnergy step_energy(const ProblemFile& problem, std::span<const double> x) {
  const std::vector<Rational> all = to_rationals(x);
  const std::vector<Rational> u = twice_the_mean(problem, all);
  StepEnergy result;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const Rational term = u[i] * all[all.size() - u.size() + i] / 2;
    result.work += term;
    result.size += abs(term);
  }
  if (problem.form != ProblemForm::global) return result;
  const std::vector<Rational> v = to_rationals(problem.impact->before), momentum = product(problem.M, v, false);
  result.before = 0;
  for (std::size_t i = 0; i < v.size(); ++i) *result.before += v[i] * momentum[i] / 2;
  return result;
}

}  // namespace slipproof
