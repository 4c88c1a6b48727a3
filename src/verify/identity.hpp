// Identities between rational functions, proved for all parameters: both sides are the same quotient of polynomials.
#pragma once

#include "claims/compiled.hpp"

namespace slipproof {

/// Whether what a formula claims is equality of rational functions of the parameters and the force, and true as such:
/// wherever its denominators are not 0 and, with modes, their equations are regular. False: not shown.
bool is_identity(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading);

}  // namespace slipproof
