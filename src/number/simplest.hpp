// Small numbers: how tall a rational is, and the least tall one in an interval.
#pragma once

#include <optional>

#include "number/rational.hpp"

namespace slipproof {

/// The larger of |numerator| and denominator.
Integer height(const Rational& x);

/// The rational of smallest denominator, and then of smallest absolute value, strictly between the ends; no value: an
/// infinite end. Throws std::invalid_argument if there is nothing between them.
Rational simplest_between(const std::optional<Rational>& lower, const std::optional<Rational>& upper);

}  // namespace slipproof
