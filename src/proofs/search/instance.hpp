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

/// Rational values of all variables for which the formula is true: simple values are tried for one variable after
/// another, inside of what the conditions that are linear in it alone allow; what linear equations determine is solved
/// for. Some attempts add that one of `boundaries` is zero. Of a disjunction a part is chosen first; every other
/// attempt only looks at one of inequalities in the end. Nothing where `attempts` of both kinds find none.
std::optional<std::vector<Rational>> find_instance(const Ring& ring, const Formula& formula,
                                                   const InstanceSearch& search);

/// Whether the formula is true, with a value for each variable of the ring.
bool holds_at(const Formula& formula, const std::vector<Rational>& values);

}  // namespace slipproof::prove
