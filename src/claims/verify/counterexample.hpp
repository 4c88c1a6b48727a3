// From a sample at which a claim fails to counterexamples that people can check: one that can be built, and the
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
  std::vector<Rational> realisable;  ///< the simplest of those that can be built; empty if there is none
};

/// What ClaimResult shows of them; `simpler` only where there is something to choose.
struct Counterexamples {
  Counterexample shown;
  std::optional<Counterexample> simpler;
};

enum class Showing : std::uint8_t {
  as_found,  ///< one of the samples that are given
  simplest   ///< simpler ones, too, and bicycles that can be built, drawn from the seed, where none of those given can
};

/// The samples of these, without what is shown of them.
struct SimplestFailures {
  Simplified shown;
  std::optional<Simplified> simpler;
};

/// The search for them, which is what takes long.
SimplestFailures simplest_failures(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                   Reading reading, const FailingSamples& failing, Showing showing, std::uint64_t seed);

/// As ClaimResult has them.
Counterexamples counterexamples(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                Reading reading, const SimplestFailures& failures);

}  // namespace slipproof
