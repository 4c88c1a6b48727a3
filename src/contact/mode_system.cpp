#include "contact/mode_system.hpp"

#include <algorithm>

#include "number/effort.hpp"

namespace slipproof {

ScaledProblem::ScaledProblem(const ContactProblem& problem) {
  for (std::size_t i = 0; i < problem.size(); ++i) {
    std::vector<Rational> row = problem.W[i];
    row.push_back(problem.q[i]);
    factor.push_back(common_denominator(row));
    rows.push_back(clear_denominators(row));
    for (const Integer& x : rows.back()) bits = std::max(bits, bit_count(x));
  }
  for (const Rational& mu : problem.mu) {
    friction.push_back(numerator(mu));
    unit.push_back(denominator(mu));
    bits = std::max(bits, bit_count(friction.back()) + bit_count(unit.back()));
  }
}

/// A component of w, times its factor and the pivot.
Integer ScaledProblem::acceleration(std::size_t row, const std::vector<Integer>& z, const Integer& pivot) const {
  Integer w = rows[row].back() * pivot;
  for (std::size_t j = 0; j < z.size(); ++j) {
    if (!z[j].is_zero()) w += rows[row][j] * z[j];
  }
  return w;
}

RawFraction ScaledProblem::condition_value(const ProblemCondition& condition, const std::vector<Integer>& z,
                                           const Integer& pivot) const {
  const std::size_t i = condition.contact, normal = friction.empty() ? i : 2 * i;
  switch (condition.kind) {
    case StateCondition::pushes:
      return {z[normal], pivot};
    case StateCondition::holds_forward:
      return {friction[i] * z[normal] - unit[i] * z[normal + 1], unit[i] * pivot};
    case StateCondition::holds_backward:
      return {friction[i] * z[normal] + unit[i] * z[normal + 1], unit[i] * pivot};
    case StateCondition::slips_forward:
      return {acceleration(normal + 1, z, pivot), factor[normal + 1] * pivot};
    case StateCondition::slips_backward:
      return {-acceleration(normal + 1, z, pivot), factor[normal + 1] * pivot};
    default:
      return {acceleration(normal, z, pivot), factor[normal] * pivot};
  }
}

std::size_t unknown_count(const ContactProblem& problem, const ProblemMode& mode) {
  std::size_t count = 0;
  for (const ContactState state : mode) {
    if (state != ContactState::lift) count += problem.frictional() && state == ContactState::stick ? 2 : 1;
  }
  return count;
}

ModeSystem::ModeSystem(const ScaledProblem& problem, const ProblemMode& mode) : size_(problem.rows.size()) {
  const bool frictional = !problem.friction.empty();
  std::vector<std::size_t> equations;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const std::size_t normal = frictional ? 2 * i : i;
    if (mode[i] == ContactState::lift) continue;
    equations.push_back(normal);
    if (!frictional || mode[i] == ContactState::stick) {
      columns_.push_back({{normal, 1}});
    } else {
      const Integer& friction = problem.friction[i];
      columns_.push_back(
          {{normal, problem.unit[i]}, {normal + 1, slip_direction(mode[i]) > 0 ? Integer(-friction) : friction}});
    }
    if (frictional && mode[i] == ContactState::stick) {
      equations.push_back(normal + 1);
      columns_.push_back({{normal + 1, 1}});
    }
  }
  IntegerMatrix matrix;
  for (const std::size_t row : equations) {
    std::vector<Integer> entries;
    for (const Column& column : columns_) {
      Integer sum = 0;
      for (const auto& [j, factor] : column) sum += problem.rows[row][j] * factor;
      entries.push_back(std::move(sum));
    }
    entries.push_back(-problem.rows[row].back());
    matrix.push_back(std::move(entries));
  }
  echelon_ = eliminate(std::move(matrix), columns_.size());
}

bool ModeSystem::solvable() const {
  return std::all_of(echelon_.rows.begin() + static_cast<std::ptrdiff_t>(rank()), echelon_.rows.end(),
                     [](const std::vector<Integer>& row) { return row.back().is_zero(); });
}

void ModeSystem::add(std::vector<Rational>& z, std::size_t k, const Rational& y) const {
  for (const auto& [j, factor] : columns_[k]) z[j] += y * Rational(factor);
}

std::vector<Integer> ModeSystem::scaled_solution() const {
  std::vector<Integer> z(size_);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    for (const auto& [j, factor] : columns_[k]) z[j] = echelon_.rows[k].back() * factor;
  }
  return z;
}

std::vector<Rational> ModeSystem::solution() const {
  std::vector<Rational> z(size_);
  for (std::size_t i = 0; i < rank(); ++i) {
    const Integer& value = echelon_.rows[i].back();
    if (!value.is_zero()) add(z, echelon_.pivot_columns[i], Rational(value, echelon_.pivot));
  }
  return z;
}

RationalMatrix ModeSystem::directions() const {
  RationalMatrix result;
  const auto& pivots = echelon_.pivot_columns;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (std::find(pivots.begin(), pivots.end(), k) != pivots.end()) continue;
    std::vector<Rational>& z = result.emplace_back(size_);
    for (std::size_t i = 0; i < rank(); ++i) {
      const Integer& value = echelon_.rows[i][k];
      if (!value.is_zero()) add(z, pivots[i], Rational(Integer(-value), echelon_.pivot));
    }
    add(z, k, 1);
  }
  return result;
}

}  // namespace slipproof
