// Linear equations between the unknowns of the model and the force: "Consequences and systems" of proofs/MEANING.md.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "meaning/world.hpp"

namespace slipproof::meaning {

inline const std::vector<std::string> unknowns = {"a", "a_y", "phi", "eps1", "eps2", "eps3",
                                                  "T", "S2",  "S3",  "N2",   "N3"};

/// Coefficients of the unknowns, of the force variable, and the constant; it vanishes.
using Row = std::vector<Rational>;
using Rows = std::vector<Row>;
inline constexpr std::size_t force_column = 11, constant_column = 12;

/// Nothing if it is undefined or not linear.
std::optional<Row> linear(const Tree& equation, const World& world);

/// The model's equations of motion with both wheels on the road; with a mode, those of its contacts, too.
Rows model_rows(const World& world, std::optional<ContactMode> mode);

/// By elimination, the columns in `order` first: each row begins with a 1 in a column where all others are 0.
class Echelon {
 public:
  Echelon(Rows rows, const std::vector<std::size_t>& order);

  bool solvable() const { return solvable_; }
  /// Whether all solutions satisfy an equation.
  bool implies(const Row& row) const;
  /// What solves the equations: these values, but for columns of `free_to_change` in which a row begins.
  Row solution(Row values, const std::vector<std::size_t>& free_to_change) const;
  /// Rows in which none of the columns occurs: what the others say of the rest, if the columns came first.
  Rows without(const std::set<std::size_t>& columns) const;

 private:
  Row reduced(Row row) const;

  std::vector<std::pair<std::size_t, Row>> rows_;  ///< with the column in which each begins
  bool solvable_ = true;
};

std::vector<std::size_t> all_columns();

}  // namespace slipproof::meaning
