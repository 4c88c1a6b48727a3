// From a sample at which a claim fails, finds counterexamples that people can check: one that can be built, and the
// simplest.
#pragma once

#include <optional>
#include <vector>

#include "claims/sampling/simplify.hpp"
#include "claims/verify/verify.hpp"

namespace slipproof {

/// Samples at which a claim fails.
struct FailingSamples {
  std::vector<Rational> simplest;
  std::vector<Rational> realisable;  ///< the simplest that can be built; empty if there is none
};

/// The counterexamples as in ClaimResult; `simpler` only if there is a choice.
struct Counterexamples {
  Counterexample shown;
  std::optional<Counterexample> simpler;
};

enum class Showing : std::uint8_t {
  as_found,  ///< one of the given samples
  simplest   ///< also simpler ones; and, if no given sample can be built, bicycles that can be, drawn by the seed
};

/// The samples of the counterexamples, without their details.
struct SimplestFailures {
  Simplified shown;
  std::optional<Simplified> simpler;
};

/// Searches for these samples; this is the part that takes long.
SimplestFailures simplest_failures(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                   Reading reading, const FailingSamples& failing, Showing showing, std::uint64_t seed);

/// The counterexamples as in ClaimResult.
Counterexamples counterexamples(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                Reading reading, const SimplestFailures& failures);

}  // namespace slipproof
