// Linear equations between the unknowns of the mechanism and the force: "Consequences and systems" of
// proofs/MEANING.md.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "claims/meaning/second_judge/tree.hpp"

namespace slipproof::meaning {

class World;

/// Coefficients of the unknowns, then of the force variable, and the constant; it vanishes.
using Row = std::vector<Rational>;
using Rows = std::vector<Row>;

/// row + factor other.
Row added(Row row, const Rational& factor, const Row& other);

/// Nothing if it is undefined or not linear.
std::optional<Row> linear(const Tree& equation, const World& world);

/// By elimination, the columns in `order` first: each row begins with a 1 in a column where all others are 0.
class Echelon {
 public:
  Echelon(Rows rows, const std::vector<std::size_t>& order);

  bool solvable() const { return rest_.empty(); }
  /// What is left without the columns in the order, not 0.
  const Rows& rest() const { return rest_; }
  /// Whether all solutions satisfy an equation.
  bool implies(const Row& row) const;
  /// What solves the equations: these values, but for columns of `free_to_change` in which a row begins.
  Row solution(Row values, const std::vector<std::size_t>& free_to_change) const;
  /// Rows in which none of the columns occurs: what the others say of the rest, if the columns came first.
  Rows without(const std::set<std::size_t>& columns) const;
  /// The row that begins in the column; null: none.
  const Row* begins_in(std::size_t column) const;

 private:
  Row reduced(Row row) const;

  std::vector<std::pair<std::size_t, Row>> rows_;  ///< with the column in which each begins
  Rows rest_;
};

/// 0, 1, ..., one less than the count.
std::vector<std::size_t> first_columns(std::size_t count);

}  // namespace slipproof::meaning
