// The constants of the running error bounds; src/floating/tape/MATHEMATICS.md derives what they mean.
#pragma once

namespace slipproof {

/// Twice the unit roundoff 2^-53, so that what a bound itself loses to underflow is paid for.
inline constexpr double batch_rounding = 0x1p-52;
/// Pays for the roundings of a bound, at most seven.
inline constexpr double bound_inflation = 1 + 0x1p-49;
/// Exceeds the total underflow in a product or quotient and in its error bound, if divisors are below the largest
/// allowed one.
inline constexpr double batch_underflow = 0x1p-560;
inline constexpr double batch_largest_divisor = 0x1p500;

}  // namespace slipproof
