// Elimination in rows of polynomials along a line, without fractions. Where a pivot or a factor that is divided out
// vanishes, the elimination differs, so these polynomials are critical.
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "mechanics/lines/critical_set.hpp"

namespace slipproof {

/// Coefficients of the unknowns, the force variable and 1.
using PolynomialRow = std::vector<IntegerPolynomial>;

/// Equations, solved for as many unknowns as they determine.
class SolvedRows {
 public:
  SolvedRows(std::vector<PolynomialRow> rows, std::size_t unknowns, CriticalSet& found);

  /// Whether there are solutions at some force.
  bool solvable() const { return solvable_; }
  /// The unknowns that the equations leave open.
  const std::vector<std::size_t>& free() const { return free_; }
  /// Writes a form on the solutions in the free unknowns, multiplied by a polynomial that is critical anyway; returns
  /// that polynomial.
  IntegerPolynomial reduce(PolynomialRow& form) const;

 private:
  std::optional<std::pair<std::size_t, std::size_t>> next_pivot(const std::vector<bool>& used) const;
  void subtract(PolynomialRow& row, const PolynomialRow& pivot, std::size_t column);
  void add_rest(const PolynomialRow& row);

  std::size_t unknowns_;
  std::vector<PolynomialRow> rows_;
  std::vector<std::optional<std::size_t>> pivot_row_;  ///< by unknown; nothing: the unknown is free
  std::vector<std::size_t> free_;
  bool solvable_ = true;
  CriticalSet& found_;
};

/// Conditions of a mode, from which unknowns and then the force are eliminated by Fourier and Motzkin. Signs of
/// coefficients change along the line, so every two conditions are combined. Chernikov's rule keeps that few: once k
/// columns are gone, a combination of more than k + 1 of the given conditions follows from others, at every place.
class Conditions {
 public:
  Conditions(std::vector<PolynomialRow> given, CriticalSet& found);

  /// Eliminates the column; false, and then nothing is left to go on with, if that gives too many combinations.
  bool eliminate(std::size_t column);
  /// What is left, each once but for its sign.
  std::vector<PolynomialRow> rows() const;

 private:
  struct Combination {
    std::vector<std::size_t> of;  ///< the given conditions in it, ascending
    PolynomialRow row;
    std::weak_ordering operator<=>(const Combination&) const = default;
  };
  void combine(const Combination& x, const Combination& y, std::size_t column);

  std::set<Combination> left_;
  std::size_t eliminated_ = 0;
  CriticalSet& found_;
};

}  // namespace slipproof
