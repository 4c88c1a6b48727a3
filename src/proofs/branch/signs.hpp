// The signs of polynomials from those of their factors. The sign of an irreducible factor is a fact in force, or is
// found by substitution of slack variables (slack.hpp) and then derived as a step of the proof. All functions here
// assume that facts in force stay in the state: once the sign of a polynomial is known, it is not determined again in
// the branch.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// The sign of an irreducible polynomial; nullptr while unknown. The thorough pass also looks for > 0 where only >= 0
/// is known. Valid until the next fact comes in.
const KnownSign* sign_of(Context& context, State& state, const Polynomial& factor, Pass pass = Pass::quick);

/// p as a number times a product of strict facts; nothing where the sign of a factor is not known.
std::optional<WeightedProduct> as_known_product(Context& context, State& state, const Polynomial& p);

}  // namespace slipproof::prove
