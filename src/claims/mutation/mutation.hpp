// Is a claims file tight? Changes every formula in every small way; each change must be noticed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "claims/judge/judge.hpp"
#include "claims/mutation/claims_mutants.hpp"
#include "claims/mutation/settle.hpp"

namespace slipproof {

/// The result for a mutant. All but the last are exact.
enum class MutantEnd : std::uint8_t {
  refuted,     ///< a claim is false at a sample where it was not
  no_value,    ///< a claim has no value at a sample where it had one
  reach,       ///< no claim fails, but one says something about other bicycles or forces than before
  vacuous,     ///< it is true for all parameters and any motion
  equivalent,  ///< it says the same as before
  theorem,     ///< it says something else, which is true for all parameters, too
  survivor     ///< none of these
};
inline constexpr std::array<MutantEnd, 7> all_mutant_ends{MutantEnd::refuted, MutantEnd::no_value,   MutantEnd::reach,
                                                          MutantEnd::vacuous, MutantEnd::equivalent, MutantEnd::theorem,
                                                          MutantEnd::survivor};
std::string_view name(MutantEnd end);

struct MutantResult {
  ClaimsMutant mutant;
  MutantEnd end = MutantEnd::survivor;
  std::size_t claim = 0;         ///< the claim that notices it, or that the argument is about
  Reason reason = Reason::none;  ///< refuted: why
  std::vector<Rational> sample;  ///< values of the parameters of the mutant's setting; empty if no sample is needed
  std::optional<Rational> force;
  std::string argument;
  std::vector<Lemma> lemmas;  ///< that the argument uses
};

struct MutationOptions {
  std::uint64_t samples = 400;        ///< for each setting and every mutant
  std::uint64_t more_samples = 4000;  ///< for mutants that survive those and have no argument
  std::uint64_t lines = 64;           ///< for each claim that such a mutant is about
  std::uint64_t seed = 1;
  unsigned threads = 0;     ///< 0: all cores
  std::uint64_t every = 1;  ///< judge one mutant out of so many
  std::function<void(std::uint64_t, std::uint64_t)> progress;
};

struct MutationResult {
  ClaimsFile file;  ///< the file in the reading that was mutated
  std::uint64_t samples = 0, more_samples = 0, lines = 0, seed = 0;
  std::vector<MutantResult> mutants;  ///< in the order of the file
  std::vector<std::size_t> vacuous;   ///< claims about motions that are true for any motion
  /// Claims that are refuted or undecided unchanged, or hold at no sample: no change of them could be noticed.
  std::vector<std::size_t> not_mutated;

  std::uint64_t count(MutantEnd end) const;
};

/// Judges the mutants of the repaired reading. The result does not depend on the number of threads.
MutationResult judge_mutants(const ClaimsFile& file, const MutationOptions& options = {});

}  // namespace slipproof
