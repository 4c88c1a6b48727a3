// Samples near the edges of the domains of their parameters.
#pragma once

#include <cstdint>
#include <vector>

#include "claims/paper/compiled.hpp"

namespace slipproof {

/// The values with some parameters moved close to the lower ends of their domains and some made large, as `variation`
/// chooses; unchanged if the result is not a sample. Only domains of the form `PARAMETER > EXPRESSION` are used.
std::vector<Rational> toward_edges(const Setting& setting, const CompiledSetting& compiled,
                                   const std::vector<Rational>& values, std::uint64_t variation);

}  // namespace slipproof
