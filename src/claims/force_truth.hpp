// Where on the line of forces a statement is true.
#pragma once

#include <optional>
#include <vector>

#include "claims/evaluate.hpp"
#include "modes/force_interval.hpp"
#include "number/rational_function.hpp"

namespace slipproof {

/// Functions of F are equal or not; which is greater is decided only if they differ by a constant.
template <>
struct FieldOf<RationalFunction> {
  RationalFunction constant(const Rational& value) const { return value; }
  bool is_zero(const RationalFunction& x) const { return x.is_zero(); }
  std::optional<int> compare(const RationalFunction& x, const RationalFunction& y) const {
    const RationalFunction difference = x - y;
    if (!difference.is_constant()) return std::nullopt;
    return sign(difference.numerator().coefficient(0));
  }
};

/// A statement has one truth on all of these forces.
struct TruthCell {
  ForceInterval forces;
  Truth truth;
};

/// The line of forces from -oo to +oo, cut where the truth of `statement` changes; neighbouring cells differ. The
/// evaluator gives F the value RationalFunction::variable(). Exact for comparisons whose difference is a quotient of
/// polynomials of degree at most 1 (a zero of its denominator is undefined, also if it could be cancelled); any other
/// that varies with F is undecided everywhere.
std::vector<TruthCell> truth_over_forces(const Program& statement, Evaluator<RationalFunction>& evaluator);

/// The forces in `within` at which the statement is true, if that is one interval and no force of it is undefined or
/// undecided. Nothing otherwise.
std::optional<ForceInterval> true_interval(const Program& statement, Evaluator<RationalFunction>& evaluator,
                                           const ForceInterval& within = {});

}  // namespace slipproof
