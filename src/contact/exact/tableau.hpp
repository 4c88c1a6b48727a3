// Linear equations of a mode between forces, solved as contacts are decided one after the other.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/number/rational.hpp"
#include "base/rounding/approximate.hpp"

namespace slipproof {

/// W, q and the coefficients of friction.
template <class Number>
struct LinearProblem {
  std::vector<std::vector<Number>> W;
  std::vector<Number> q, mu;

  LinearProblem(const RationalMatrix& matrix, const std::vector<Rational>& constant,
                const std::vector<Rational>& friction)
      : q(constant.begin(), constant.end()), mu(friction.begin(), friction.end()) {
    for (const auto& row : matrix) W.emplace_back(row.begin(), row.end());
  }
  explicit LinearProblem(const LinearProblem<Rational>& exact) : LinearProblem(exact.W, exact.q, exact.mu) {}
};

inline std::optional<int> sure_sign(const Rational& x) {
  return x.sign();
}
inline bool is_surely(int sign, const std::optional<int>& of) {
  return of == sign;
}

/// Whether the equations between forces of closed contacts have a solution, as far as it is known without the others.
enum class Solvable : std::uint8_t { maybe, no, unsure };

/// Linear equations between forces: those of closed contacts as far as they are solved, and velocities of contacts that
/// are not decided yet. Numbers are exact or have error bounds.
template <class Number>
class Tableau {
 public:
  explicit Tableau(const LinearProblem<Number>& problem) {
    for (std::size_t i = 0; i < problem.q.size(); ++i) {
      columns_.push_back({i, false});
      rows_.push_back({i, Row::Kind::velocity, problem.W[i], problem.q[i]});
    }
  }

  std::size_t entries() const { return columns_.size() * rows_.size(); }

  /// The force is 0.
  void drop_column(std::size_t component) {
    const std::size_t j = column_of(component);
    columns_.erase(columns_.begin() + static_cast<std::ptrdiff_t>(j));
    for (Row& row : rows_) row.a.erase(row.a.begin() + static_cast<std::ptrdiff_t>(j));
  }
  /// The velocity may be anything.
  void drop_row(std::size_t component) {
    std::erase_if(rows_, [&](const Row& row) { return row.is_velocity(component); });
  }

  /// The force of `tangential` is `factor` times that of `normal`.
  void tie(std::size_t tangential, std::size_t normal, const Number& factor) {
    const std::size_t from = column_of(tangential), to = column_of(normal);
    for (Row& row : rows_) row.a[to] = row.a[to] + factor * row.a[from];
    drop_column(tangential);
  }

  /// The force may be anything.
  void free_column(std::size_t component) { columns_[column_of(component)].closed = true; }
  /// The velocity is 0.
  void stop_row(std::size_t component) {
    for (Row& row : rows_) {
      if (row.is_velocity(component)) row.kind = Row::Kind::zero;
    }
  }

  /// Solves the rows that are 0 for forces of closed contacts, as many as can be. `no` if one of them has no solution
  /// whatever the other contacts do.
  Solvable eliminate() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_[i].kind != Row::Kind::zero) continue;
      if (const auto pivot = pivot_of(rows_[i])) {
        solve(i, *pivot);
      } else {
        const Solvable row = solvable(rows_[i]);
        if (row != Solvable::maybe) return row;
      }
    }
    return Solvable::maybe;
  }

  /// Once all contacts are decided: whether something leaves forces open.
  bool is_determined() const { return columns_.empty(); }
  /// The forces, with the open ones at value(component).
  template <class Value>
  std::vector<Number> forces(std::size_t size, const Value& value) const {
    std::vector<Number> r(size), open;
    for (const Column& column : columns_) {
      open.push_back(value(column.component));
      r[column.component] = open.back();
    }
    for (const Row& row : rows_) {
      if (row.kind != Row::Kind::force) continue;
      Number& sum = r[row.component] = row.constant;
      for (std::size_t j = 0; j < open.size(); ++j) sum = sum + row.a[j] * open[j];
    }
    return r;
  }

 private:
  struct Column {
    std::size_t component;
    bool closed;  ///< its contact is
  };
  struct Row {
    enum class Kind : std::uint8_t { velocity, zero, force };
    std::size_t component;
    Kind kind;
    std::vector<Number> a;
    Number constant;
    bool is_velocity(std::size_t i) const { return kind == Kind::velocity && component == i; }
  };

  std::size_t column_of(std::size_t component) const {
    return static_cast<std::size_t>(std::ranges::find(columns_, component, &Column::component) - columns_.begin());
  }

  static bool is_not_zero(const Number& a) {
    const std::optional<int> sign = sure_sign(a);
    return sign && *sign != 0;
  }

  /// The first force of a closed contact that can be solved for; with error bounds the one with the largest factor.
  std::optional<std::size_t> pivot_of(const Row& row) const {
    std::optional<std::size_t> best;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (!columns_[j].closed || !is_not_zero(row.a[j])) continue;
      if (!best || is_larger(row.a[j], row.a[*best])) best = j;
    }
    return best;
  }
  static bool is_larger(const Rational&, const Rational&) { return false; }
  static bool is_larger(const Approximate& a, const Approximate& b) { return std::fabs(a.value) > std::fabs(b.value); }

  /// Of a row without a pivot.
  Solvable solvable(const Row& row) const {
    bool others = false;  // forces of contacts that are not decided yet
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      const bool zero = is_surely(0, sure_sign(row.a[j]));
      if (columns_[j].closed && !zero) return Solvable::unsure;
      others = others || !zero;
    }
    if (others) return Solvable::maybe;
    const std::optional<int> constant = sure_sign(row.constant);
    return !constant ? Solvable::unsure : *constant == 0 ? Solvable::maybe : Solvable::no;
  }

  /// Row i, which is 0, for the force of column j, which it replaces everywhere.
  void solve(std::size_t i, std::size_t j) {
    Row& pivot = rows_[i];
    const Number by = -pivot.a[j];
    const auto place = static_cast<std::ptrdiff_t>(j);
    pivot.a.erase(pivot.a.begin() + place);
    for (Number& a : pivot.a) a = a / by;
    pivot.constant = pivot.constant / by;
    pivot.kind = Row::Kind::force;
    pivot.component = columns_[j].component;
    columns_.erase(columns_.begin() + place);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (k == i) continue;
      const Number factor = rows_[k].a[j];
      rows_[k].a.erase(rows_[k].a.begin() + place);
      if (factor.is_zero()) continue;
      for (std::size_t l = 0; l < pivot.a.size(); ++l) rows_[k].a[l] = rows_[k].a[l] + factor * pivot.a[l];
      rows_[k].constant = rows_[k].constant + factor * pivot.constant;
    }
  }

  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

}  // namespace slipproof
