// Linear programming over products of hypotheses (Handelman's and Schmüdgen's certificates). A sum of products of
// inequalities with weights >= 0, and of equations with polynomial multipliers, that is 0 while a strict product has a
// weight above 0, is a contradiction. For products up to a degree every monomial of the sum must vanish, which is
// linear in the weights and in the coefficients of the multipliers. If the facts bound no compact set, there may be no
// such sum of any degree.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// Products up to the degree of context.reach, none if that is 1; on success the steps end in the contradiction.
bool refute_products(Context& context, State& state);

}  // namespace slipproof::prove
