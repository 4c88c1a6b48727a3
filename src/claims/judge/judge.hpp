// Is a claim true at a sample? Compares the claim with the exact answer of the mode equations.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims/sampling/solved_sample.hpp"

namespace slipproof {

enum class Outcome : std::uint8_t {
  outside,  ///< the sample is not in the claim's region, or the claim says nothing about it
  holds,
  refuted,
  undecided  ///< the claim has no value at the sample, or its value was not found
};

/// How a claim fails.
enum class Reason : std::uint8_t {
  none,
  ends,       ///< the forces agree except for ends that belong to one side only
  forces,     ///< the mode has other forces than the claim says
  exists,     ///< there is a motion that the claim calls impossible
  formula,    ///< a formula has another value
  continuum,  ///< there is a continuum of motions where the claim states one motion
  extra,      ///< there is a motion that the claim does not mention
  missing,    ///< a motion of the claim does not exist
  uncovered,  ///< none of the claims covers this bicycle
  limit,      ///< false however large the parameter is
  equation,   ///< an equation does not follow
  no_value,   ///< undefined in the claim's own region
  unsure      ///< nothing is undefined, but a comparison over the forces was not decided
};
std::string_view name(Reason reason);

/// The judgement of a claim at one sample. Forces are values of the paper's force variable.
struct Judgement {
  Outcome outcome = Outcome::outside;
  Reason reason = Reason::none;
  std::optional<MechanismMode> mode;       ///< the mode that the judgement is about
  std::optional<ForceInterval> claimed;    ///< interval: what the claim says
  std::optional<ForceInterval> real;       ///< interval, impossible: the forces that the mode has
  std::optional<ForceInterval> witnesses;  ///< forces at which claim and truth differ
  std::optional<std::size_t> equation;     ///< consequence: which of the equations does not follow
};

/// Judges a claim, given by its index, in a reading. `compiled` must be made from `file`, the sample from the claim's
/// setting.
Judgement judge(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
                SolvedSample& sample);

}  // namespace slipproof
