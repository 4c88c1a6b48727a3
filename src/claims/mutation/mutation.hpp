// Is a claims file tight? Every formula of it is changed in every small way, and each change must be noticed.
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

/// How a mutant ended. All but the last are exact.
enum class MutantEnd : std::uint8_t {
  refuted,     ///< a claim is false at a sample at which it was not
  no_value,    ///< a claim has no value at a sample at which it had one
  reach,       ///< no claim fails, but one speaks of other bicycles or forces than before
  vacuous,     ///< true of all parameters, whatever the motion
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
  std::size_t claim = 0;         ///< that notices it, or that the argument is about
  Reason reason = Reason::none;  ///< refuted: why
  std::vector<Rational> sample;  ///< of the parameters of the mutant's setting; empty if no sample is needed
  std::optional<Rational> force;
  std::string argument;
  std::vector<Lemma> lemmas;  ///< that the argument rests on
};

struct MutationOptions {
  std::uint64_t samples = 400;        ///< of each setting, for every mutant
  std::uint64_t more_samples = 4000;  ///< for what survives those, and has no argument
  std::uint64_t lines = 64;           ///< of each claim that it is about, for the same
  std::uint64_t seed = 1;
  unsigned threads = 0;     ///< 0: all cores
  std::uint64_t every = 1;  ///< judge one mutant in so many
  std::function<void(std::uint64_t, std::uint64_t)> progress;
};

struct MutationResult {
  ClaimsFile file;  ///< in the reading that was mutated
  std::uint64_t samples = 0, more_samples = 0, lines = 0, seed = 0;
  std::vector<MutantResult> mutants;  ///< in the order of the file
  std::vector<std::size_t> vacuous;   ///< claims about motions that are true whatever the motion
  /// Claims that are refuted or undecided as they stand, or hold at no sample: nothing can be noticed about them.
  std::vector<std::size_t> not_mutated;

  std::uint64_t count(MutantEnd end) const;
};

/// The mutants of the repaired reading. The same result at any number of threads.
MutationResult judge_mutants(const ClaimsFile& file, const MutationOptions& options = {});

}  // namespace slipproof
