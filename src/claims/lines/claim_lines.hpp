// Lines of bicycles along which a claim is judged.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "claims/sampling/claim_parts.hpp"
#include "mechanics/family/solved_sample.hpp"
#include "mechanics/lines/line.hpp"

namespace slipproof {

struct ClaimLines {
  ClaimParts parts;
  std::vector<bool> matters;  ///< by parameter: whether lines may vary it
};

/// Nothing for a claim that is judged only at samples: it is about too many modes, or no parameter matters to it. The
/// programs are those of `compiled`.
std::optional<ClaimLines> claim_lines(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                      Reading reading);

/// The parameters of `matters` on which no equation in the claim's region depends. A line that varies only these stays
/// on the surface that the region is.
std::vector<bool> on_surface(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
                             const std::vector<bool>& matters);

/// Calls `visit` for the bicycles of points_on() that are in the domain, solved for the claim's modes only, until it
/// returns false. Returns the number of cells.
std::size_t visit_line(const Line& line, const CompiledSetting& compiled, const ClaimParts& parts,
                       const std::function<bool(SolvedSample&)>& visit);

}  // namespace slipproof
