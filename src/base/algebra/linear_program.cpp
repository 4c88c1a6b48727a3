#include "base/algebra/linear_program.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "base/algebra/elimination.hpp"

namespace slipproof {

namespace {

using Row = std::vector<Integer>;  // constant, then the coefficient of each variable in the columns
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

}  // namespace

/// Each row's variable as an affine form of the columns' variables (Chvatal's dictionary). Variables below `free_count`
/// may have any sign, all others are >= 0; the point of the dictionary has 0 for all variables in columns.
///
/// In integers over one denominator: entries are minors of the constraints, so that divisions by it are exact. Each
/// constraint, and with it the meaning of its variable, is multiplied by the common denominator of its numbers.
class LinearProgram::Dictionary {
 public:
  struct GivenUp {};

  Dictionary(const AffineForm& objective, const std::vector<AffineForm>& constraints, std::size_t max_pivots)
      : max_pivots_(max_pivots), free_count_(objective.coefficients.size()) {
    for (std::size_t i = 0; i < free_count_; ++i) columns_.push_back(i);
    for (const AffineForm& c : constraints) {
      std::tie(rows_.emplace_back(), scales_.emplace_back()) = to_row(c);
      basis_.push_back(free_count_ + basis_.size());
    }
    std::tie(objective_, objective_scale_) = to_row(objective);
  }

  /// Moves to a feasible point; false if there is none.
  bool start() {
    bring_free_variables_in();
    return make_feasible();
  }

  /// From a feasible point.
  LinearOptimum solve() {
    LinearOptimum result;
    result.kind = lower_objective() ? LinearOptimum::Kind::attained : LinearOptimum::Kind::unbounded;
    result.value = value();
    result.x.resize(free_count_);
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      if (basis_[i] < free_count_) result.x[basis_[i]] = Rational(rows_[i][0], denominator_);
    }
    result.multipliers.resize(basis_.size());
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (columns_[j] < free_count_) continue;
      const std::size_t i = columns_[j] - free_count_;
      result.multipliers[i] = Rational(objective_[j + 1] * scales_[i], denominator_ * objective_scale_);
    }
    result.pivots = pivots_;
    return result;
  }

  /// The least value of another objective, from a feasible point; nothing if it is unbounded.
  std::optional<Rational> least(const AffineForm& objective) {
    const auto [own, scale] = to_row(objective);
    objective_scale_ = scale;
    objective_.assign(columns_.size() + 1, 0);
    objective_[0] = own[0] * denominator_;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (columns_[j] < free_count_) objective_[j + 1] = own[columns_[j] + 1] * denominator_;
    }
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      if (basis_[i] >= free_count_) continue;
      const Integer& factor = own[basis_[i] + 1];
      for (std::size_t j = 0; j < objective_.size(); ++j) objective_[j].add_product(factor, rows_[i][j]);
    }
    if (!lower_objective()) return std::nullopt;
    return value();
  }

  std::size_t pivots() const { return pivots_; }

 private:
  /// In integers, and what the form was multiplied by.
  static std::pair<Row, Integer> to_row(const AffineForm& form) {
    Integer scale = common_denominator(form.coefficients, denominator(form.constant));
    Row row{integer_times(form.constant, scale)};
    row.reserve(form.coefficients.size() + 1);
    for (const Rational& x : form.coefficients) row.push_back(integer_times(x, scale));
    return {std::move(row), std::move(scale)};
  }

  Rational value() const { return Rational(objective_[0], denominator_ * objective_scale_); }

  /// Replaces the variable of a column in another row, using `leaving` solved for it.
  void substitute(Row& row, std::size_t column, const Row& leaving) const {
    const Integer& pivot = leaving[column + 1];
    const bool negative = pivot.sign() < 0;
    const Integer factor = std::exchange(row[column + 1], Integer(0));
    if (factor.is_zero() && (negative ? -pivot : pivot) == denominator_) return;
    for (std::size_t j = 0; j < row.size(); ++j) {
      const bool changes = !factor.is_zero() && !leaving[j].is_zero() && j != column + 1;
      if (row[j].is_zero() && !changes) continue;
      row[j] *= pivot;
      if (changes) row[j].subtract_product(factor, leaving[j]);
      if (!denominator_.is_one()) row[j] = exact_quotient(row[j], denominator_);
      if (negative) row[j] = -row[j];
    }
    row[column + 1] = negative ? Integer(-factor) : factor;
  }

  void pivot(std::size_t r, std::size_t column) {
    if (pivots_ == max_pivots_) throw GivenUp{};
    ++pivots_;
    const Row leaving = rows_[r];
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (i != r) substitute(rows_[i], column, leaving);
    }
    substitute(objective_, column, leaving);
    if (!artificial_.empty()) substitute(artificial_, column, leaving);
    // d v = c + ... + a x  =>  a x = d v - c - ...
    Row& row = rows_[r];
    row[column + 1] = -denominator_;
    denominator_ = abs(leaving[column + 1]);
    if (leaving[column + 1].sign() > 0) {
      for (Integer& x : row) x = -x;
    }
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
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (basis_[i] < free_count_ || rows_[i][column + 1].sign() >= 0) continue;
      const int order = best == none ? -1 : compare_ratios(i, best, column);
      if (order < 0 || (order == 0 && basis_[i] < basis_[best])) best = i;
    }
    return best;
  }

  /// Whether row i holds the column before row k (-1), after it (1) or with it.
  int compare_ratios(std::size_t i, std::size_t k, std::size_t column) const {
    const Integer x = rows_[i][0] * rows_[k][column + 1], y = rows_[k][0] * rows_[i][column + 1];
    return y.compare(x);
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
      if (worst == none || rows_[i][0] * scale_of(worst) < rows_[worst][0] * scale_of(i)) worst = i;
    }
    if (worst == none) return true;
    const std::size_t added = free_count_ + rows_.size();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      rows_[i].push_back(basis_[i] < free_count_ ? Integer(0) : Integer(denominator_ * scale_of(i)));
    }
    objective_.push_back(0);
    artificial_.assign(objective_.size(), 0);
    artificial_.back() = denominator_;
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

  /// Of the constraint whose variable is a row's.
  const Integer& scale_of(std::size_t row) const { return scales_[basis_[row] - free_count_]; }

  std::size_t max_pivots_, pivots_ = 0;
  std::size_t free_count_;
  Integer denominator_ = 1, objective_scale_;
  std::vector<Integer> scales_;  ///< of the constraints
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
  // Entries of a dictionary are minors; a step takes some products, and many entries are 0.
  const Work pivot = times(rows * columns, product_work(bits * std::min(rows, columns)));
  const LinearOptimum result =
      minimize(objective, constraints, static_cast<std::size_t>(std::min<Work>(effort.left() / pivot, 1U << 30U)));
  effort.spend(result.kind == LinearOptimum::Kind::given_up ? unlimited : times(pivot, result.pivots));
  return result;
}

}  // namespace slipproof
