// What decides a claim at one bicycle, for any kind: conditions, modes, and what they are compared with.
#pragma once

#include <optional>
#include <vector>

#include "claims/paper/compiled.hpp"

namespace slipproof {

struct ClaimParts {
  std::vector<const Program*> conditions;  ///< truths over parameters, definitions and the force; those of all claims
                                           ///< that it refers to among them
  std::vector<const Program*> of_motions;  ///< truths over the quantities of each mode's motion, too
  std::vector<MechanismMode> modes;        ///< the modes whose motions decide the claim
  bool modes_meet = false;                 ///< the forces of one mode are compared with those of another
  std::optional<std::size_t> grows;        ///< for a limit: the parameter that goes to the end of its domain
  /// Linear equations between the model's unknowns, including those of claims that it refers to.
  std::vector<const Program*> equations;
  bool model_equations = false;  ///< the mechanism's own equations are among them
  bool too_many_modes = false;   ///< too many for lines: see max_line_modes
};

/// A claim about all motions of a mechanism with more modes is judged at samples only, not along lines.
inline constexpr std::size_t max_line_modes = 256;

/// The programs are those of `compiled`.
ClaimParts parts_of(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading);

/// The slots that programs use, each once: directly, or through definitions.
std::vector<std::size_t> slots_behind(const Scope& scope, const std::vector<const Program*>& programs);

}  // namespace slipproof
