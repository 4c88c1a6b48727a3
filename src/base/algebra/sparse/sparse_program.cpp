#include "base/algebra/sparse/sparse_program.hpp"

#include <algorithm>
#include <optional>

namespace slipproof {

namespace {

Rational product(const SparseVector& column, const std::vector<Rational>& y) {
  Rational sum;
  for (const auto& [row, value] : column) {
    if (!y[row].is_zero()) sum += value * y[row];
  }
  return sum;
}

/// Columns beyond those of the program are artificial: one for each row, with value 0. As long as a basis gives one
/// another value, or a negative one to a column that has none, the costs are those of its distance from what is
/// allowed.
class SparseSimplex {
 public:
  SparseSimplex(const SparseProgram& program, std::vector<std::size_t> basis, Effort& effort)
      : program_(program), effort_(effort), own_(program.columns.size()), basis_(std::move(basis)) {
    for (std::uint32_t i = 0; i < program.rows(); ++i) artificial_.push_back({{i, 1}});
  }

  SparseOptimum run() {
    while (true) {
      decompose();
      const bool feasible = price();
      const auto entering = find_entering();
      if (!entering) {
        result_.kind = feasible ? SparseOptimum::Kind::optimal : SparseOptimum::Kind::infeasible;
        return finished();
      }
      const std::vector<Rational> change = change_of(*entering);
      const auto leaving = find_leaving(change);
      if (!leaving) {
        result_.kind = SparseOptimum::Kind::unbounded;
        result_.direction.assign(own_, 0);
        result_.direction[entering->column] = entering->up ? 1 : -1;
        for (std::size_t k = 0; k < basis_.size(); ++k) {
          if (basis_[k] < own_) result_.direction[basis_[k]] = change[k];
        }
        return finished();
      }
      basis_[*leaving] = entering->column;
      ++result_.pivots;
    }
  }

 private:
  struct Entering {
    std::size_t column;
    bool up;
  };

  const SparseVector& entries(std::size_t column) const {
    return column < own_ ? program_.columns[column].entries : artificial_[column - own_];
  }
  bool is_free(std::size_t column) const { return column < own_ && program_.columns[column].is_free; }

  void decompose() {
    const auto factor = [&] {
      std::vector<const SparseVector*> columns;
      for (const std::size_t column : basis_) columns.push_back(&entries(column));
      factors_.emplace(program_.rows(), columns, effort_);
    };
    factor();
    if (!factors_->dependent().empty() || !factors_->free_rows().empty()) {
      for (auto k = factors_->dependent().rbegin(); k != factors_->dependent().rend(); ++k) {
        basis_.erase(basis_.begin() + static_cast<std::ptrdiff_t>(*k));
      }
      for (const std::size_t row : factors_->free_rows()) basis_.push_back(own_ + row);
      factor();
    }
    x_ = factors_->solve(program_.right_side);
  }

  /// -1: too low, 1: too high, 0: allowed.
  int off(std::size_t k) const {
    if (is_free(basis_[k])) return 0;
    const int sign = x_[k].sign();
    return basis_[k] >= own_ ? sign : std::min(sign, 0);
  }

  /// Whether all values are allowed. If not, the prices are those of the distance.
  bool price() {
    std::vector<Rational> costs(basis_.size());
    feasible_ = true;
    for (std::size_t k = 0; k < basis_.size(); ++k) {
      if (const int side = off(k)) costs[k] = side, feasible_ = false;
    }
    for (std::size_t k = 0; feasible_ && k < basis_.size(); ++k) {
      if (basis_[k] < own_) costs[k] = program_.columns[basis_[k]].cost;
    }
    y_ = factors_->solve_transposed(std::move(costs));
    return feasible_;
  }

  /// The column whose cost falls fastest; after many pivots the first one whose does (Bland's rule).
  std::optional<Entering> find_entering() {
    constexpr std::size_t greedy_pivots = 200;
    std::vector<bool> basic(own_);
    for (const std::size_t column : basis_) {
      if (column < own_) basic[column] = true;
    }
    std::optional<Entering> best;
    Rational fastest;
    for (std::size_t j = 0; j < own_; ++j) {
      if (basic[j]) continue;
      const ProgramColumn& column = program_.columns[j];
      Rational slope = product(column.entries, y_);
      if (feasible_) slope -= column.cost;
      if (slope.sign() < 0 && !column.is_free) continue;
      const bool up = slope.sign() > 0;
      slope = abs(std::move(slope));
      if (slope.is_zero() || (best && slope <= fastest)) continue;
      best = Entering{j, up};
      fastest = std::move(slope);
      if (result_.pivots > greedy_pivots) break;
    }
    return best;
  }

  /// Of each basic value, as the entering one changes by 1 in its direction.
  std::vector<Rational> change_of(const Entering& entering) const {
    std::vector<Rational> column(program_.rows());
    for (const auto& [row, value] : entries(entering.column)) column[row] = entering.up ? -value : value;
    return factors_->solve(std::move(column));
  }

  /// The basic column that first comes to where it must stop: at 0.
  std::optional<std::size_t> find_leaving(const std::vector<Rational>& change) const {
    std::optional<std::size_t> first;
    Rational least;
    for (std::size_t k = 0; k < basis_.size(); ++k) {
      if (change[k].is_zero() || is_free(basis_[k])) continue;
      const bool artificial = basis_[k] >= own_;
      const bool stops = x_[k].is_zero() ? artificial || change[k].sign() < 0 : change[k].sign() != x_[k].sign();
      if (!stops) continue;
      Rational step = abs(Rational(x_[k] / change[k]));
      // Among those that stop together an artificial one leaves first: it does not come back.
      if (first &&
          (step > least || (step == least && (artificial ? basis_[*first] >= own_ && basis_[k] > basis_[*first]
                                                         : basis_[k] > basis_[*first] || basis_[*first] >= own_))))
        continue;
      first = k;
      least = std::move(step);
    }
    return first;
  }

  SparseOptimum finished() {
    result_.x.assign(own_, 0);
    for (std::size_t k = 0; k < basis_.size(); ++k) {
      if (basis_[k] < own_) result_.x[basis_[k]] = x_[k];
    }
    result_.y = std::move(y_);
    result_.basis = std::move(basis_);
    std::erase_if(result_.basis, [&](std::size_t column) { return column >= own_; });
    return std::move(result_);
  }

  const SparseProgram& program_;
  Effort& effort_;
  const std::size_t own_;
  std::vector<SparseVector> artificial_;
  std::vector<std::size_t> basis_;
  std::optional<SparseBasis> factors_;
  std::vector<Rational> x_, y_;
  bool feasible_ = false;
  SparseOptimum result_;
};

}  // namespace

SparseOptimum minimize(const SparseProgram& program, std::vector<std::size_t> basis, Effort& effort) {
  return SparseSimplex(program, std::move(basis), effort).run();
}

}  // namespace slipproof
