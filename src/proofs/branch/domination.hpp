// Positivity as a sum of products: a polynomial is positive if subtracting multiples of the facts, by monomials of
// known sign, leaves no negative coefficient.
//
// The monomials show which multiples help: multiples of facts cover each monomial with a negative coefficient, and new
// monomials that these bring are covered in turn. A linear program finds how much of each to take. Substitution of
// slack variables (slack.hpp) needs a fact that is linear in a variable with a positive coefficient; this does not. But
// it finds no product of two facts of more than one term.
#pragma once

#include <optional>
#include <vector>

#include "proofs/branch/slack.hpp"

namespace slipproof::prove {

/// Facts and monomials whose sum is p, without a multiplier. Nothing where p is not positive in this way; it is
/// negative at the samples in `negative`.
std::optional<SlackForm> find_dominated_form(const std::vector<Fact>& facts, const Polynomial& p,
                                             const SampleSet& negative, Budget& budget);

}  // namespace slipproof::prove
