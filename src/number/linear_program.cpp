#include "number/linear_program.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace slipproof {

namespace {

using Row = std::vector<Rational>;  // constant, then the coefficient of each variable in the columns
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

}  // namespace

/// Each row's variable as an affine form of the columns' variables (Chvatal's dictionary). Variables below `free_count`
/// may have any sign, all others are >= 0; the point of the dictionary has 0 for all variables in columns.
class LinearProgram::Dictionary {
 public:
  struct GivenUp {};

  Dictionary(const AffineForm& objective, const std::vector<AffineForm>& constraints, std::size_t max_pivots)
      : max_pivots_(max_pivots), free_count_(objective.coefficients.size()), objective_(to_row(objective)) {
    for (std::size_t i = 0; i < free_count_; ++i) columns_.push_back(i);
    for (const AffineForm& c : constraints) {
      rows_.push_back(to_row(c));
      basis_.push_back(free_count_ + basis_.size());
    }
  }

  /// Goes to a feasible point; false if there is none.
  bool start() {
    bring_free_variables_in();
    return make_feasible();
  }

  /// From a feasible point.
  LinearOptimum solve() {
    LinearOptimum result;
    result.kind = lower_objective() ? LinearOptimum::Kind::attained : LinearOptimum::Kind::unbounded;
    result.value = objective_[0];
    result.x.resize(free_count_);
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      if (basis_[i] < free_count_) result.x[basis_[i]] = rows_[i][0];
    }
    result.multipliers.resize(basis_.size());
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (columns_[j] >= free_count_) result.multipliers[columns_[j] - free_count_] = objective_[j + 1];
    }
    result.pivots = pivots_;
    return result;
  }

  /// The least value of another objective, from a feasible point; nothing if it is unbounded.
  std::optional<Rational> least(const AffineForm& objective) {
    objective_.assign(columns_.size() + 1, 0);
    objective_[0] = objective.constant;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (columns_[j] < free_count_) objective_[j + 1] = objective.coefficients[columns_[j]];
    }
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      if (basis_[i] < free_count_) add(objective_, objective.coefficients[basis_[i]], rows_[i]);
    }
    if (!lower_objective()) return std::nullopt;
    return objective_[0];
  }

  std::size_t pivots() const { return pivots_; }

 private:
  static Row to_row(const AffineForm& form) {
    Row row{form.constant};
    row.insert(row.end(), form.coefficients.begin(), form.coefficients.end());
    return row;
  }

  /// row += factor * pivot_row, where `factor` is the row's coefficient of the column that leaves.
  static void substitute(Row& row, std::size_t column, const Row& replacement) {
    add(row, std::exchange(row[column + 1], Rational(0)), replacement);
  }

  /// row += factor * addend.
  static void add(Row& row, const Rational& factor, const Row& addend) {
    if (factor.is_zero()) return;
    for (std::size_t j = 0; j < row.size(); ++j) {
      if (!addend[j].is_zero()) row[j] += factor * addend[j];
    }
  }

  void pivot(std::size_t r, std::size_t column) {
    if (pivots_ == max_pivots_) throw GivenUp{};
    ++pivots_;
    Row& row = rows_[r];
    // v = c + ... + a x  =>  x = (v - c - ...) / a
    const Rational inverse = 1 / std::exchange(row[column + 1], Rational(-1));
    for (Rational& x : row) {
      if (!x.is_zero()) x *= -inverse;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (i != r) substitute(rows_[i], column, row);
    }
    substitute(objective_, column, row);
    if (!artificial_.empty()) substitute(artificial_, column, row);
    std::swap(basis_[r], columns_[column]);
  }

  void bring_free_variables_in() {
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (basis_[i] < free_count_ || rows_[i][j + 1].is_zero()) continue;
        pivot(i, j);
        break;
      }
    }
  }

  /// The column to enter: the one with the least variable that lowers the row; none at the optimum.
  std::size_t entering(const Row& goal) const {
    std::size_t best = none;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (columns_[j] < free_count_ || goal[j + 1].sign() >= 0) continue;
      if (best == none || columns_[j] < columns_[best]) best = j;
    }
    return best;
  }

  /// The row that holds an entering column first; none if no row does.
  std::size_t leaving(std::size_t column) const {
    std::size_t best = none;
    Rational least;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (basis_[i] < free_count_ || rows_[i][column + 1].sign() >= 0) continue;
      const Rational ratio = rows_[i][0] / -rows_[i][column + 1];
      if (best == none || ratio < least || (ratio == least && basis_[i] < basis_[best])) {
        best = i;
        least = ratio;
      }
    }
    return best;
  }

  /// False if the objective has no least value.
  bool lower_objective() {
    for (std::size_t j = 0; j < columns_.size(); ++j) {  // a free variable that no constraint holds
      if (columns_[j] < free_count_ && !objective_[j + 1].is_zero()) return false;
    }
    return improve(objective_);
  }

  /// Lowers `goal`, one of the objectives, to its optimum; false if it has none.
  bool improve(const Row& goal) {
    for (std::size_t column = entering(goal); column != none; column = entering(goal)) {
      const std::size_t row = leaving(column);
      if (row == none) return false;
      pivot(row, column);
    }
    return true;
  }

  /// The first phase: a variable that is added to every constraint, as small as possible.
  bool make_feasible() {
    std::size_t worst = none;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (basis_[i] < free_count_ || rows_[i][0].sign() >= 0) continue;
      if (worst == none || rows_[i][0] < rows_[worst][0]) worst = i;
    }
    if (worst == none) return true;
    const std::size_t added = free_count_ + rows_.size();
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].push_back(basis_[i] < free_count_ ? 0 : 1);
    objective_.push_back(0);
    artificial_.assign(objective_.size(), 0);
    artificial_.back() = 1;
    columns_.push_back(added);
    pivot(worst, columns_.size() - 1);
    improve(artificial_);
    if (artificial_[0].sign() > 0) return false;
    std::size_t column = none;
    for (std::size_t i = 0; i < rows_.size(); ++i) {  // it may stay in the basis, at 0
      if (basis_[i] != added) continue;
      for (column = 0; rows_[i][column + 1].is_zero() || columns_[column] < free_count_;) ++column;
      pivot(i, column);
      break;
    }
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (columns_[j] == added) column = j;
    }
    const auto at = static_cast<std::ptrdiff_t>(column);
    columns_.erase(columns_.begin() + at);
    for (Row& row : rows_) row.erase(row.begin() + at + 1);
    objective_.erase(objective_.begin() + at + 1);
    artificial_.clear();
    return true;
  }

  std::size_t max_pivots_, pivots_ = 0;
  std::size_t free_count_;
  Row objective_, artificial_;
  std::vector<std::size_t> columns_, basis_;
  std::vector<Row> rows_;
};

LinearProgram::LinearProgram(std::size_t variables, const std::vector<AffineForm>& constraints)
    : dictionary_(std::make_unique<Dictionary>(AffineForm{0, std::vector<Rational>(variables)}, constraints,
                                               std::numeric_limits<std::size_t>::max())),
      is_feasible_(dictionary_->start()) {}

LinearProgram::~LinearProgram() = default;

std::optional<Rational> LinearProgram::least(const AffineForm& objective) {
  return dictionary_->least(objective);
}

Rational AffineForm::at(const std::vector<Rational>& x) const {
  Rational value = constant;
  for (std::size_t i = 0; i < coefficients.size(); ++i) value += coefficients[i] * x[i];
  return value;
}

LinearOptimum minimize(const AffineForm& objective, const std::vector<AffineForm>& constraints,
                       std::size_t max_pivots) {
  LinearProgram::Dictionary dictionary(objective, constraints, max_pivots);
  try {
    return dictionary.start() ? dictionary.solve() : LinearOptimum();
  } catch (const LinearProgram::Dictionary::GivenUp&) {
    LinearOptimum result;
    result.kind = LinearOptimum::Kind::given_up;
    result.pivots = dictionary.pivots();
    return result;
  }
}

LinearOptimum minimize(const AffineForm& objective, const std::vector<AffineForm>& constraints, Effort& effort) {
  std::size_t bits = 0;
  for (const AffineForm& form : constraints) {
    bits = std::max(bits, bit_count(form.constant));
    for (const Rational& x : form.coefficients) bits = std::max(bits, bit_count(x));
  }
  const std::size_t columns = objective.coefficients.size() + 1, rows = constraints.size() + 1;
  // Entries of a dictionary are quotients of minors; a sum of fractions takes some products, and many entries are 0.
  const Work pivot = times(rows * columns, product_work(bits * std::min(rows, columns)));
  const LinearOptimum result =
      minimize(objective, constraints, static_cast<std::size_t>(std::min<Work>(effort.left() / pivot, 1U << 30U)));
  effort.spend(result.kind == LinearOptimum::Kind::given_up ? endless : times(pivot, result.pivots));
  return result;
}

}  // namespace slipproof
