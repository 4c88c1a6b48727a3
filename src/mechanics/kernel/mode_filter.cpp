#include "mechanics/kernel/mode_filter.hpp"

#include <algorithm>
#include <cmath>

namespace slipproof {

class ModeFilter::Elimination {
 public:
  explicit Elimination(std::size_t unknowns) : unknowns_(unknowns), pivot_row_(unknowns) {}

  void add(const Row& row) { rows_.push_back(row); }

  /// Whether every unknown is fixed.
  bool solve() {
    std::vector<bool> used(rows_.size());
    for (std::size_t column = 0; column < unknowns_; ++column) {
      const auto pivot = pivot_in(column, used);
      if (!pivot) return false;
      used[*pivot] = true;
      pivot_row_[column] = *pivot;
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (i != *pivot) subtract(rows_[i], rows_[*pivot], column);
      }
    }
    return true;
  }

  /// A form where the equations hold, over the load.
  Affine<Approximate> on_solution(const Row& form) const {
    Affine<Approximate> result(form[unknowns_ + 1], form[unknowns_]);
    for (std::size_t j = 0; j < unknowns_; ++j) {
      if (form[j].is_zero()) continue;
      const Row& row = rows_[pivot_row_[j]];
      const Approximate factor = form[j] / row[j];
      result.beta = result.beta - factor * row[unknowns_];
      result.alpha = result.alpha - factor * row[unknowns_ + 1];
    }
    return result;
  }

 private:
  /// The largest of the entries that are surely not 0.
  std::optional<std::size_t> pivot_in(std::size_t column, const std::vector<bool>& used) const {
    std::optional<std::size_t> best;
    double most = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Approximate& entry = rows_[i][column];
      const double size = std::fabs(entry.value);
      if (used[i] || !(size > entry.error) || !(size > most)) continue;
      best = i;
      most = size;
    }
    return best;
  }

  void subtract(Row& row, const Row& pivot, std::size_t column) const {
    if (row[column].is_zero()) return;
    const Approximate factor = row[column] / pivot[column];
    for (std::size_t j = column + 1; j < row.size(); ++j) {
      if (!pivot[j].is_zero()) row[j] = row[j] - factor * pivot[j];
    }
    row[column] = Approximate();
  }

  std::size_t unknowns_;
  std::vector<Row> rows_;
  std::vector<std::size_t> pivot_row_;  ///< by unknown
};

ModeFilter::ModeFilter(const FrictionProblem& problem, const std::optional<Rational>& load, const ForceInterval& domain,
                       const StatesOfElements& states)
    : unknowns_(problem.unknowns) {
  if (load && problem.has_load) load_ = Approximate(*load);
  if (domain.lower()) above_.emplace_back(*domain.lower());
  if (domain.upper()) below_.emplace_back(*domain.upper());
  for (const AffineForm& form : problem.equations) equations_.push_back(row_of(form));
  states_ = rows_by_state<StateRows>(
      problem, states, [&](StateRows& rows, const AffineForm& form) { rows.equations.push_back(row_of(form)); },
      [&](StateRows& rows, const AffineForm& form, StateCondition) { rows.conditions.push_back(row_of(form)); });
}

ModeFilter::Row ModeFilter::row_of(const AffineForm& form) const {
  Row row;
  for (const Rational& coefficient : form.coefficients) row.emplace_back(coefficient);
  row.emplace_back(form.constant);
  if (load_) {
    row.back() = row.back() + row[unknowns_] * *load_;
    row[unknowns_] = Approximate();
  }
  return row;
}

bool ModeFilter::excludes(const MechanismMode& mode) const {
  Elimination elimination(unknowns_);
  for (const Row& row : equations_) elimination.add(row);
  for (std::size_t i = 0; i < mode.size(); ++i) {
    for (const Row& row : states_[i][static_cast<std::size_t>(mode[i])].equations) elimination.add(row);
  }
  if (!elimination.solve()) return false;
  std::vector<Approximate> above = above_, below = below_;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    for (const Row& row : states_[i][static_cast<std::size_t>(mode[i])].conditions) {
      const Affine<Approximate> value = elimination.on_solution(row);
      const std::optional<int> slope = sure_sign(value.beta);
      if (slope == 0 && sure_sign(value.alpha) == -1) return true;
      if (!slope || *slope == 0) continue;
      (*slope > 0 ? above : below).push_back(-value.alpha / value.beta);
    }
  }
  return std::any_of(above.begin(), above.end(), [&](const Approximate& lower) {
    return std::any_of(below.begin(), below.end(),
                       [&](const Approximate& upper) { return sure_sign(lower - upper) == 1; });
  });
}

}  // namespace slipproof
