// Positivity as a sum of products: a polynomial is positive if multiples of the facts, by monomials of known sign, can
// be taken from it until no negative coefficient is left.
//
// Which multiples help is read off the monomials: each that has a negative coefficient is covered by the multiples of
// facts that have it, too, and what these bring along is covered in turn. How much of each is a linear program. Where
// substitution of slack variables (slack.hpp) needs a fact that is linear in a variable with a positive coefficient,
// this does not; but it finds no product of two facts of more than one term.
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
