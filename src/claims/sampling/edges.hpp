// Samples near the edges of the domains of their parameters.
#pragma once

#include <cstdint>
#include <vector>

#include "claims/paper/compiled.hpp"

namespace slipproof {

/// The values with some parameters close to the lower ends of their domains and some large, as `variation` has it; as
/// they are where that is no sample. Domains are understood that read `PARAMETER > EXPRESSION`.
std::vector<Rational> toward_edges(const Setting& setting, const CompiledSetting& compiled,
                                   const std::vector<Rational>& values, std::uint64_t variation);

}  // namespace slipproof
