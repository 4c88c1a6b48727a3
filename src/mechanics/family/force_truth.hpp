// Finds where on the line of forces a statement is true.
#pragma once

#include <optional>
#include <vector>

#include "base/algebra/rational_function.hpp"
#include "base/expression/evaluate.hpp"
#include "base/expression/with_divisors.hpp"
#include "mechanics/elements/force_interval.hpp"

namespace slipproof {

/// A polynomial that vanishes where the divisor of a function of F does.
inline std::optional<Polynomial> divisor_of(const RationalFunction& x) {
  return x.numerator().degree() == 0 ? std::nullopt : std::optional(x.numerator());
}
using ForceFunction = WithDivisors<RationalFunction, Polynomial>;

/// Functions of F can be equal or not. Which one is greater is decided only if they differ by a constant.
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

/// A set of forces on which a statement has one truth value.
struct TruthCell {
  ForceInterval forces;
  Truth truth;
};

/// Cuts the line of forces from -oo to +oo where the truth of `statement` changes; neighbouring cells differ. The
/// evaluator must give F the value RationalFunction::variable(). At a zero of a divisor the statement is undefined,
/// even if the zero could be cancelled. Exact if all real zeros of the comparisons and their divisors are rational; a
/// comparison with an irrational zero is undecided everywhere.
std::vector<TruthCell> truth_over_forces(const Program& statement, Evaluator<ForceFunction>& evaluator);

/// The forces in `within` at which the statement is true, if they form one interval and the statement is defined and
/// decided at every force of `within`. Otherwise nothing.
std::optional<ForceInterval> true_interval(const Program& statement, Evaluator<ForceFunction>& evaluator,
                                           const ForceInterval& within = {});

}  // namespace slipproof
