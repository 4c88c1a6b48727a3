// Numbers that meet a formula.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "proofs/statement/formula.hpp"

namespace slipproof::prove {

struct InstanceSearch {
  std::vector<Polynomial> boundaries = {};
  int attempts = 0;
  /// Conditions in one variable that are not linear: its values are chosen between their roots, and at them.
  bool roots = false;
  /// A further condition on the values; the search continues if it is false.
  std::function<bool(const std::vector<Rational>& values)> accept = {};
};

/// Rational values of all variables for which the formula is true. Chooses simple values for one variable after
/// another, within the bounds of the conditions that are linear in it alone, and solves linear equations. Some attempts
/// require that one of `boundaries` is zero. Each attempt first chooses a part of each disjunction; every other attempt
/// leaves disjunctions of inequalities to the end. Nothing if `attempts` of both kinds fail.
std::optional<std::vector<Rational>> find_instance(const Ring& ring, const Formula& formula,
                                                   const InstanceSearch& search);

/// Whether the formula is true, with a value for each variable of the ring.
bool holds_at(const Formula& formula, const std::vector<Rational>& values);

}  // namespace slipproof::prove
