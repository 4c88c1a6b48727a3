// A textbook simplex in rationals, for tests that must not ask the library: Bland's rule, so that it ends.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof::test {

using Rows = std::vector<std::vector<Rational>>;

/// x with E x = e is x0 + N y: x0 and the columns of N; nothing if there is none. Rows of E have e at their end.
struct AffineSolutions {
  std::vector<Rational> x0;
  Rows directions;
};
inline std::optional<AffineSolutions> solve_equations(Rows E, std::size_t unknowns) {
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; column < unknowns; ++column) {
    std::size_t row = pivots.size();
    while (row < E.size() && E[row][column].is_zero()) ++row;
    if (row == E.size()) continue;
    std::swap(E[row], E[pivots.size()]);
    std::vector<Rational>& pivot = E[pivots.size()];
    const Rational by = pivot[column];
    for (Rational& x : pivot) x /= by;
    for (std::size_t i = 0; i < E.size(); ++i) {
      if (i == pivots.size() || E[i][column].is_zero()) continue;
      const Rational factor = E[i][column];
      for (std::size_t j = column; j <= unknowns; ++j) E[i][j] -= factor * pivot[j];
    }
    pivots.push_back(column);
  }
  for (std::size_t i = pivots.size(); i < E.size(); ++i) {
    if (!E[i][unknowns].is_zero()) return std::nullopt;
  }
  AffineSolutions result{std::vector<Rational>(unknowns), {}};
  for (std::size_t i = 0; i < pivots.size(); ++i) result.x0[pivots[i]] = E[i][unknowns];
  for (std::size_t column = 0, next = 0; column < unknowns; ++column) {
    if (next < pivots.size() && pivots[next] == column) {
      ++next;
      continue;
    }
    std::vector<Rational> direction(unknowns);
    direction[column] = 1;
    for (std::size_t i = 0; i < pivots.size(); ++i) direction[pivots[i]] = -E[i][column];
    result.directions.push_back(std::move(direction));
  }
  return result;
}

/// max c.y where A y <= b, y of any sign.
class ExactSimplex {
 public:
  ExactSimplex(const Rows& A, const std::vector<Rational>& b, std::size_t unknowns)
      : rows_(A.size()), unknowns_(unknowns), width_(2 * unknowns + A.size() + 1) {
    for (std::size_t i = 0; i < rows_; ++i) {
      std::vector<Rational> row(width_ + 1);
      for (std::size_t j = 0; j < unknowns; ++j) row[2 * j] = A[i][j], row[2 * j + 1] = -A[i][j];
      row[2 * unknowns + i] = 1;
      row[width_ - 1] = -1;  // the artificial variable
      row[width_] = b[i];
      table_.push_back(std::move(row));
      basis_.push_back(2 * unknowns + i);
    }
    feasible_ = find_start();
  }
  bool feasible() const { return feasible_; }

  /// Nothing: without a bound.
  std::optional<Rational> maximum(const std::vector<Rational>& c) {
    std::vector<Rational> objective(width_ + 1);
    for (std::size_t j = 0; j < unknowns_; ++j) objective[2 * j] = c[j], objective[2 * j + 1] = -c[j];
    price_out(objective);
    if (!climb(objective, width_ - 1)) return std::nullopt;
    return -objective[width_];
  }

 private:
  bool find_start() {
    std::size_t least = 0;
    for (std::size_t i = 1; i < rows_; ++i) {
      if (table_[i][width_] < table_[least][width_]) least = i;
    }
    if (rows_ == 0 || table_[least][width_].sign() >= 0) return true;
    std::vector<Rational> objective(width_ + 1);
    objective[width_ - 1] = -1;
    pivot(least, width_ - 1, objective);
    climb(objective, width_);
    if (!objective[width_].is_zero()) return false;
    for (std::size_t i = 0; i < rows_; ++i) {
      if (basis_[i] != width_ - 1) continue;
      for (std::size_t j = 0; j + 1 < width_; ++j) {
        if (table_[i][j].is_zero()) continue;
        pivot(i, j, objective);
        break;
      }
    }
    return true;
  }
  void price_out(std::vector<Rational>& objective) const {
    for (std::size_t i = 0; i < rows_; ++i) {
      const Rational factor = objective[basis_[i]];
      if (factor.is_zero()) continue;
      for (std::size_t j = 0; j <= width_; ++j) objective[j] -= factor * table_[i][j];
    }
  }
  /// False: without a bound.
  bool climb(std::vector<Rational>& objective, std::size_t columns) {
    while (true) {
      std::size_t enters = 0;
      while (enters < columns && objective[enters].sign() <= 0) ++enters;
      if (enters == columns) return true;
      std::optional<std::size_t> leaves;
      for (std::size_t i = 0; i < rows_; ++i) {
        if (table_[i][enters].sign() <= 0) continue;
        if (!leaves) {
          leaves = i;
          continue;
        }
        const Rational here = table_[i][width_] / table_[i][enters],
                       there = table_[*leaves][width_] / table_[*leaves][enters];
        if (here < there || (here == there && basis_[i] < basis_[*leaves])) leaves = i;
      }
      if (!leaves) return false;
      pivot(*leaves, enters, objective);
    }
  }
  void pivot(std::size_t row, std::size_t column, std::vector<Rational>& objective) {
    const Rational by = table_[row][column];
    for (Rational& x : table_[row]) x /= by;
    const auto clear = [&](std::vector<Rational>& other) {
      const Rational factor = other[column];
      if (factor.is_zero()) return;
      for (std::size_t j = 0; j <= width_; ++j) other[j] -= factor * table_[row][j];
    };
    for (std::size_t i = 0; i < rows_; ++i) {
      if (i != row) clear(table_[i]);
    }
    clear(objective);
    basis_[row] = column;
  }

  std::size_t rows_, unknowns_, width_;
  Rows table_;
  std::vector<std::size_t> basis_;
  bool feasible_ = false;
};

}  // namespace slipproof::test
