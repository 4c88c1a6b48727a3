// Numbers that meet a formula.
#pragma once

#include <optional>
#include <vector>

#include "prove/budget.hpp"
#include "prove/formula.hpp"

namespace slipproof::prove {

/// Rational values of all variables for which the formula is true: simple values are tried for one variable after
/// another, inside of what the conditions that are linear in it alone allow; what linear equations determine is solved
/// for. Some attempts add that one of `boundaries` is zero. Of a disjunction a part is chosen first; every other
/// attempt only looks at one of inequalities in the end. Nothing where `attempts` of both kinds find none.
std::optional<std::vector<Rational>> find_instance(const Ring& ring, const Formula& formula,
                                                   const std::vector<Polynomial>& boundaries, int attempts,
                                                   Budget& budget);

}  // namespace slipproof::prove
