// Is a claim true at a sample? Compares the claim with the exact answer of the mode equations.
#pragma once

#include <optional>

#include "claims/paper/compiled.hpp"
#include "mechanics/family/solved_sample.hpp"

namespace slipproof {

enum class Outcome : std::uint8_t {
  outside,  ///< the sample is not in the claim's region, or the claim says nothing about it
  holds,
  refuted,
  undecided  ///< the claim has no value at the sample, or its value was not found
};

/// How a claim fails. Kinds may have reasons of their own; ClaimKind::failing() puts those in words.
struct Reason {
  std::string_view name;
  bool operator==(const Reason&) const = default;

  static const Reason none;
  static const Reason ends;       ///< the forces agree except for ends that belong to one side only
  static const Reason forces;     ///< the mode has other forces than the claim says
  static const Reason exists;     ///< there is a motion that the claim calls impossible
  static const Reason formula;    ///< a formula has another value
  static const Reason continuum;  ///< there is a continuum of motions where the claim states one motion
  static const Reason extra;      ///< there is a motion that the claim does not mention
  static const Reason missing;    ///< a motion of the claim does not exist
  static const Reason uncovered;  ///< none of the claims covers this bicycle
  static const Reason no_value;   ///< undefined in the claim's own region
  static const Reason unsure;     ///< nothing is undefined, but a comparison over the forces was not decided
};
inline constexpr Reason Reason::none{"none"}, Reason::ends{"ends"}, Reason::forces{"forces"}, Reason::exists{"exists"},
    Reason::formula{"formula"}, Reason::continuum{"continuum"}, Reason::extra{"extra"}, Reason::missing{"missing"},
    Reason::uncovered{"uncovered"}, Reason::no_value{"no value"}, Reason::unsure{"undecided"};

/// The judgement of a claim at one sample. Forces are values of the paper's force variable.
struct Judgement {
  Outcome outcome = Outcome::outside;
  Reason reason = Reason::none;
  std::optional<MechanismMode> mode;       ///< the mode that the judgement is about
  std::optional<ForceInterval> claimed;    ///< interval: what the claim says
  std::optional<ForceInterval> real;       ///< interval, impossible: the forces that the mode has
  std::optional<ForceInterval> witnesses;  ///< forces at which claim and truth differ
  std::optional<std::size_t> number;       ///< what the kind counts, for its words
};

/// Judges a claim, given by its index, in a reading. `compiled` must be made from `file`, the sample from the claim's
/// setting.
Judgement judge(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
                SolvedSample& sample);

}  // namespace slipproof
