// Removes divisions by the zero polynomial, which statements must not contain (proofs/FORMAT.md, Division).
#pragma once

#include <string>

namespace slipproof {

/// Replaces each comparison that divides by the zero polynomial, directly or through `let`, by `false`, and removes
/// such `let` lines and hints: a comparison holds only where no divisor is 0, so it holds nowhere. Returns a text
/// without such divisions, and a text that is not a statement, unchanged.
std::string without_zero_divisors(std::string text);

}  // namespace slipproof
