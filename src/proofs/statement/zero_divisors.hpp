// What divides by the zero polynomial, which no statement may (proofs/FORMAT.md, Division).
#pragma once

#include <string>

namespace slipproof {

/// The statement with `false` for each comparison that divides by the zero polynomial, directly or in what `let`
/// abbreviates, and without such `let` lines and hints: a comparison holds only where no divisor is 0, so this one
/// holds nowhere. A text without them, and one that is no statement, comes back as it is.
std::string without_zero_divisors(std::string text);

}  // namespace slipproof
