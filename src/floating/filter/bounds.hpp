// The constants of the error bounds. A test counts them anew by running the reduction over a counting number type;
// src/floating/filter/MATHEMATICS.md derives what they mean.
#pragma once

namespace slipproof {

/// Half the distance from 1 to the next binary64.
inline constexpr double unit_roundoff = 0x1p-53;

/// No expression of the reduction has a path of more rounded operations, the rounding of inputs included: 41. One more
/// pays for the second-order terms and for the roundings of the bound itself.
inline constexpr int counted_roundings = 41;
inline constexpr int error_roundings = counted_roundings + 1;

/// Inputs beyond this (in SI units) are left to the exact tier: below it no expression can overflow.
inline constexpr double input_limit = 0x1p40;

/// With inputs up to the limit, all that underflow can change in an expression: counted as 686 bits of 2^-1075, hence
/// below 2^-389; with a margin of 4 for roundings of the count's own terms.
inline constexpr int counted_underflow_bits = 686;
inline constexpr double underflow_error = 0x1p-387;

/// One operation on double-double numbers, relative: 8 u^2 covers the sum (3 u^2) and the product (7 u^2).
inline constexpr double double_double_roundoff = 0x1p-103;
/// An operation on double-double numbers underflows in up to 16 places.
inline constexpr double double_double_underflow_error = 16 * underflow_error;

}  // namespace slipproof
