// Identities between rational functions, proved for all parameters: both sides are the same quotient of polynomials,
// and what was divided by on the way is not 0.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims/identity/lemmas.hpp"
#include "claims/paper/compiled.hpp"

namespace slipproof {

/// What a formula or a consequence claims is equality of rational functions of the parameters and the force, and true
/// as such wherever everything that it divides by, the determinants of its modes included, differs from 0.
struct Identity {
  /// Of what it divides by, the factors that were not shown to differ from 0 in the claim's region, as expressions.
  std::vector<std::string> unless_zero;

  /// The claim is right, or says nothing, at every bicycle.
  bool proved() const { return unless_zero.empty(); }
};

/// Nothing: it was not shown to be one. With a book, what is not plainly of one sign is shown by its proofs.
std::optional<Identity> find_identity(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                      Reading reading, LemmaBook* book);

}  // namespace slipproof
