#include "mechanics/kernel/regular_modes.hpp"

#include <algorithm>
#include <utility>

namespace slipproof {

/// The equations of one mode. An unknown is y_k times the factor that column k has for it; those that are in no column
/// are 0.
class RegularModes::Elimination {
 public:
  explicit Elimination(const RegularModes& problem) : problem_(problem), columns_(problem.unknowns_) {
    for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i] = {{i, 1}};
  }

  void add(const Row& row) {
    if (!substitutes(row)) rows_.push_back(&row);
  }

  std::size_t unknowns() const {
    return static_cast<std::size_t>(
        std::count_if(columns_.begin(), columns_.end(), [](const Column& column) { return !column.empty(); }));
  }

  Outcome::Kind solve() {
    std::erase_if(columns_, [](const Column& column) { return column.empty(); });
    IntegerMatrix matrix;
    for (const Row* row : rows_) matrix.push_back(entries_of(*row));
    const Echelon echelon = eliminate(std::move(matrix));
    if (echelon.rank(columns_.size()) < columns_.size()) return Outcome::Kind::singular;
    if (echelon.rank() > columns_.size()) {
      return problem_.load_ ? Outcome::Kind::inconsistent : Outcome::Kind::singular;
    }
    pivot_ = echelon.pivot;
    values_.assign(problem_.right_sides_, std::vector<Integer>(problem_.unknowns_));
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      for (std::size_t side = 0; side < values_.size(); ++side) {
        for (const auto& [i, factor] : columns_[k]) {
          values_[side][i] = echelon.rows[k][columns_.size() + side] * factor;
        }
      }
    }
    cancel();
    return Outcome::Kind::regular;
  }

  /// Of a form for all loads.
  AffineForm over_load(const Row& row) const {
    Integer constant = row.entries[problem_.unknowns_] * pivot_, slope = row.entries[problem_.unknowns_ + 1] * pivot_;
    for (const std::size_t i : row.unknowns) {
      constant.add_product(row.entries[i], values_[0][i]);
      slope.add_product(row.entries[i], values_[1][i]);
    }
    AffineForm form{
        slope.is_zero() ? Rational(std::move(constant), row.factor * pivot_) : Rational(std::move(constant)),
        std::vector<Rational>(problem_.unknowns_ + 1)};
    form.coefficients.back() = Rational(std::move(slope));
    return form;
  }

  /// Of a form at the only load.
  RawFraction value(const Row& row) const {
    Integer sum = row.entries[problem_.unknowns_] * pivot_;
    for (const std::size_t i : row.unknowns) sum += row.entries[i] * values_[0][i];
    return {std::move(sum), row.factor * pivot_};
  }

  AffineSpace space() const {
    std::vector<AffineForm> solution;
    for (std::size_t i = 0; i < problem_.unknowns_; ++i) {
      AffineForm& form = solution.emplace_back();
      form.constant = Rational(values_[0][i], pivot_);
      form.coefficients.resize(problem_.unknowns_ + 1);
      if (!problem_.load_) form.coefficients.back() = Rational(values_[1][i], pivot_);
    }
    return {std::move(solution), problem_.load_};
  }

 private:
  using Column = std::vector<std::pair<std::size_t, Integer>>;

  /// Divides by the common factor of the solution, and by the sign of the pivot: every form would be multiplied by
  /// them.
  void cancel() {
    Integer common = abs(pivot_);
    for (const std::vector<Integer>& side : values_) {
      for (const Integer& value : side) {
        if (!(common == 1) && !value.is_zero()) common = gcd(common, value);
      }
    }
    if (pivot_.sign() < 0) common = -common;
    if (common == 1) return;
    pivot_ = exact_quotient(pivot_, common);
    for (std::vector<Integer>& side : values_) {
      for (Integer& value : side) value = exact_quotient(value, common);
    }
  }

  /// Whether a row only says that an unknown is 0 or a multiple of another one; then it is done.
  bool substitutes(const Row& row) {
    if (!row.homogeneous || row.unknowns.size() > 2) return false;
    std::vector<std::size_t> left;
    for (const std::size_t i : row.unknowns) {
      if (columns_[i].size() > 1 || is_multiple(i)) return false;
      if (!columns_[i].empty()) left.push_back(i);
    }
    if (left.size() == 2) {
      const Integer common = gcd(row.entries[left[0]], row.entries[left[1]]);
      columns_[left[0]] = {{left[0], row.entries[left[1]] / common}, {left[1], -row.entries[left[0]] / common}};
      multiples_.push_back(left[1]);
      columns_[left[1]].clear();
    } else if (left.size() == 1) {
      columns_[left[0]].clear();
    }
    return true;
  }

  bool is_multiple(std::size_t i) const {
    return std::find(multiples_.begin(), multiples_.end(), i) != multiples_.end();
  }

  std::vector<Integer> entries_of(const Row& row) const {
    std::vector<Integer> entries;
    entries.reserve(columns_.size() + problem_.right_sides_);
    for (const Column& column : columns_) {
      Integer& sum = entries.emplace_back();
      for (const auto& [i, factor] : column) sum += row.entries[i] * factor;
    }
    for (std::size_t side = 0; side < problem_.right_sides_; ++side) {
      entries.push_back(-row.entries[problem_.unknowns_ + side]);
    }
    return entries;
  }

  const RegularModes& problem_;
  std::vector<Column> columns_;
  std::vector<std::size_t> multiples_;  ///< unknowns in the columns of others
  std::vector<const Row*> rows_;
  Integer pivot_ = 1;
  std::vector<std::vector<Integer>> values_;  ///< of the unknowns times the pivot, for each right-hand side
};

RegularModes::RegularModes(const FrictionProblem& problem, const std::optional<Rational>& load,
                           const StatesOfElements& states)
    : unknowns_(problem.unknowns), load_(problem.has_load ? load : Rational(0)), right_sides_(load_ ? 1 : 2) {
  for (const AffineForm& form : problem.equations) equations_.push_back(row_of(form));
  states_ = rows_by_state<StateRows>(
      problem, states, [&](StateRows& rows, const AffineForm& form) { rows.equations.push_back(row_of(form)); },
      [&](StateRows& rows, const AffineForm& form, StateCondition c) {
        rows.conditions.emplace_back(row_of(form), c);
      });
}

RegularModes::Row RegularModes::row_of(const AffineForm& form) {
  std::vector<Rational> numbers(form.coefficients.begin(), form.coefficients.end() - 1);
  numbers.push_back(load_ ? Rational(form.constant + form.coefficients.back() * *load_) : form.constant);
  if (!load_) numbers.push_back(form.coefficients.back());
  Row row{{}, common_denominator(numbers), {}, true};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    row.entries.push_back(integer_times(numbers[i], row.factor));
    if (row.entries.back().is_zero()) continue;
    if (i < unknowns_) {
      row.unknowns.push_back(i);
    } else {
      row.homogeneous = false;
    }
    bits_ = std::max(bits_, bit_count(row.entries.back()));
  }
  return row;
}

/// Elimination, in which the numbers grow, then the conditions.
Work RegularModes::work_of(std::size_t unknowns) const {
  Work work = times(unknowns_ * unknowns, product_work(bits_ * (unknowns + 1)));
  for (std::size_t step = 1; step <= unknowns; ++step) {
    work = plus(work, times(3 * unknowns * (unknowns + 1), product_work(bits_ * step)));
  }
  return work;
}

RegularModes::Outcome RegularModes::solve(const MechanismMode& mode, Effort* effort) const {
  Elimination elimination(*this);
  for (const Row& row : equations_) elimination.add(row);
  for (std::size_t i = 0; i < mode.size(); ++i) {
    for (const Row& row : states_[i][static_cast<std::size_t>(mode[i])].equations) elimination.add(row);
  }
  if (effort != nullptr) effort->spend(work_of(elimination.unknowns()));
  Outcome outcome;
  outcome.kind = elimination.solve();
  if (outcome.kind != Outcome::Kind::regular) return outcome;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    for (const auto& [row, condition] : states_[i][static_cast<std::size_t>(mode[i])].conditions) {
      if (!load_) {
        outcome.conditions.push_back(elimination.over_load(row));
        continue;
      }
      const RawFraction value = elimination.value(row);
      if (value.sign() >= 0) continue;
      outcome.kind = Outcome::Kind::violated;
      outcome.violation = {{i, mode[i], condition}, Rational(value.numerator, value.denominator)};
      return outcome;
    }
  }
  outcome.space = elimination.space();
  return outcome;
}

}  // namespace slipproof
