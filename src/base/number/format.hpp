// Writing numbers: exactly, as decimals of a stated length, and as counts of something.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/number/rational.hpp"

namespace slipproof {

/// "3/4", "-5": lowest terms, the denominator left out when it is 1. parse_rational reads it back (up to its length).
std::string exact_text(const Rational& x);

/// `x` rounded to `digits` >= 1 significant digits, from its exact value, ties to even, in the layout of printf's
/// %.{digits}g: no trailing zeros; an exponent below -4 or from `digits` on is written as e-05. Throws
/// std::invalid_argument for digits < 1.
std::string decimal_text(const Rational& x, int digits);

/// A nonnegative bound in three digits, `1.23e-12`: an upper bound is rounded up, a lower bound down.
std::string at_most(double bound);
std::string at_least(double bound);

/// `5 claims`, `1 claim`.
std::string counted(std::uint64_t count, std::string_view noun);

}  // namespace slipproof
