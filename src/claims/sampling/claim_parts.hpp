// What decides a claim at one bicycle, for any kind.
#pragma once

#include <vector>

#include "claims/paper/compiled.hpp"
#include "mechanics/lines/question.hpp"

namespace slipproof {

/// The conditions are those of all claims that it refers to, too.
struct ClaimParts : Question {
  /// Linear equations between the model's unknowns, including those of claims that it refers to.
  std::vector<const Program*> equations;
  bool model_equations = false;  ///< the mechanism's own equations are among them
  bool too_many_modes = false;   ///< too many for lines: see max_line_modes
};

/// A claim about all motions of a mechanism with more modes is judged at samples only, not along lines.
inline constexpr std::size_t max_line_modes = 256;

/// The programs are those of `compiled`.
ClaimParts parts_of(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading);

}  // namespace slipproof
