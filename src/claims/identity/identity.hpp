// Identities between rational functions, proved for all parameters: both sides are the same quotient of polynomials,
// and no divisor on the way is 0.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims/identity/lemmas.hpp"
#include "claims/paper/compiled.hpp"

namespace slipproof {

/// A formula or consequence whose equation holds between rational functions of the parameters and the force. The claim
/// is then true wherever all its divisors, including the determinants of its modes, differ from 0.
struct Identity {
  /// Factors of the divisors, as expressions, that were not shown to differ from 0 in the claim's region.
  std::vector<std::string> unless_zero;
  /// Whether the force's domain plainly is an interval at every bicycle; where it is not, no claim has a value.
  bool has_interval_of_forces = false;

  /// Whether the claim is right, or says nothing, at every bicycle.
  bool proved() const { return unless_zero.empty() && has_interval_of_forces; }
};

/// Nothing if the claim was not shown to be an identity. With a book, its proofs are used for divisors that are not
/// plainly of one sign.
std::optional<Identity> find_identity(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                      Reading reading, LemmaBook* book);

}  // namespace slipproof
