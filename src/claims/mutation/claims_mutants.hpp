// Mutants of a claims file: one definition, region, set of forces or formula, changed in one place.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "claims/mutation/mutate.hpp"
#include "claims/paper/claims_file.hpp"
#include "claims/paper/compiled.hpp"

namespace slipproof {

struct ClaimsMutant {
  std::optional<BodyPart> part;  ///< the part of a claim; none: a definition is changed
  std::size_t setting = 0;       ///< the setting of a definition
  std::size_t index = 0;         ///< index of the definition in its setting, or of the claim
  std::size_t item = 0;          ///< index of an equation or assumption in its claim
  Mutant mutant;
  std::string where;                ///< `definition xi4 (line 195)`, `forces of A2.1 (line 209)`
  std::vector<std::size_t> claims;  ///< the claims whose meaning may change; only these must be judged again

  /// Whether it may contain unknowns of the model, as equations and assumptions may.
  bool is_linear() const { return part == BodyPart::equations || part == BodyPart::assume; }
  /// The unchanged expression in the file, which must be the file that the mutant was made from.
  const Expression& original(const ClaimsFile& file) const;
  /// The file with this change.
  ClaimsFile apply(const ClaimsFile& file) const;
  /// Replaces the expression in the compiled claims by `mutant.expression`, or by original() to undo that.
  void put(const Expression& expression, CompiledClaims& compiled) const;
};

/// All mutants of the printed reading of definitions and claims. Each is valid: no definition leads back to itself, and
/// what must not depend on the force does not.
std::vector<ClaimsMutant> mutants(const ClaimsFile& file);

}  // namespace slipproof
