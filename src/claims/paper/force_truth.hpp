// Where on the line of forces a statement is true.
#pragma once

#include <optional>
#include <vector>

#include "base/algebra/rational_function.hpp"
#include "base/expression/evaluate.hpp"
#include "base/expression/with_divisors.hpp"
#include "mechanics/elements/force_interval.hpp"

namespace slipproof {

/// What vanishes where a function of F does.
inline std::optional<Polynomial> divisor_of(const RationalFunction& x) {
  return x.numerator().degree() == 0 ? std::nullopt : std::optional(x.numerator());
}
using ForceFunction = WithDivisors<RationalFunction, Polynomial>;

/// Functions of F are equal or not; which is greater is decided only if they differ by a constant.
template <>
struct FieldOf<ForceFunction> {
  ForceFunction constant(const Rational& value) const { return RationalFunction(value); }
  bool is_zero(const ForceFunction& x) const { return x.value().is_zero(); }
  std::optional<int> compare(const ForceFunction& x, const ForceFunction& y) const {
    const RationalFunction difference = x.value() - y.value();
    if (difference.is_zero()) return 0;
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
/// evaluator gives F the value RationalFunction::variable(). A zero of a divisor is
/// undefined, also if it could be cancelled. Exact where all real zeros of the comparisons and their divisors are
/// rational; a comparison with another one is undecided everywhere.
std::vector<TruthCell> truth_over_forces(const Program& statement, Evaluator<ForceFunction>& evaluator);

/// The forces in `within` at which the statement is true, if that is one interval and no force of it is undefined or
/// undecided. Nothing otherwise.
std::optional<ForceInterval> true_interval(const Program& statement, Evaluator<ForceFunction>& evaluator,
                                           const ForceInterval& within = {});

}  // namespace slipproof
