// Facts coming into a state. Each is brought to a short form by what is known already, reduction by equations
// (reduction.hpp) and then the normal form (normal_form.hpp), and may shorten the others in turn. It assumes nothing of
// the fact but that the proof knows its name.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// Brings a hypothesis and its parts in; disjunctions are put aside for cases.hpp. As add() otherwise.
bool add_formula(Context& context, State& state, const std::string& name, const Formula& formula);

/// Brings a fact in; true if the state is contradictory then, its steps end in the contradiction.
bool add(Context& context, State& state, Fact fact);

}  // namespace slipproof::prove
