// Is a claim true at a sample? The exact answer of the mode equations beside what the claim says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims/sampling/solved_sample.hpp"

namespace slipproof {

enum class Outcome : std::uint8_t {
  outside,  ///< the sample is not in the claim's region, or the claim says nothing at it
  holds,
  refuted,
  undecided  ///< the claim has no value at the sample, or it was not found
};

/// How a claim fails.
enum class Reason : std::uint8_t {
  none,
  ends,       ///< the forces agree up to ends that belong to one side only
  forces,     ///< the mode has other forces
  exists,     ///< a motion that the claim calls impossible
  formula,    ///< a formula has another value
  continuum,  ///< a continuum of motions where the claim knows one
  extra,      ///< a motion that the claim does not mention
  missing,    ///< a motion of the claim that does not exist
  uncovered,  ///< a bicycle of which no line speaks
  limit,      ///< false however large the parameter
  equation,   ///< an equation that does not follow
  no_value,   ///< undefined in the claim's own region
  unsure      ///< nothing is undefined, but a comparison over the forces was not decided
};
std::string_view name(Reason reason);

/// What a claim comes to at one sample. Forces are values of the paper's force variable.
struct Judgement {
  Outcome outcome = Outcome::outside;
  Reason reason = Reason::none;
  std::optional<MechanismMode> mode;       ///< the mode it is about
  std::optional<ForceInterval> claimed;    ///< interval: what the claim says
  std::optional<ForceInterval> real;       ///< interval, impossible: the forces that the mode has
  std::optional<ForceInterval> witnesses;  ///< forces at which claim and truth differ
  std::optional<std::size_t> equation;     ///< consequence: which of the equations does not follow
};

/// Judges a claim, given by its index, in a reading. `compiled` is made from `file`, the sample from the claim's
/// setting.
Judgement judge(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
                SolvedSample& sample);

}  // namespace slipproof
