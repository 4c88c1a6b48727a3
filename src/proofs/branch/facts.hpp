// Adds facts to a state. Each is simplified by the known facts, first by equations (reduction.hpp), then to the normal
// form (normal_form.hpp), and may in turn simplify the others. The only requirement is that the proof knows the name of
// the fact.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// Brings a hypothesis and its parts in; disjunctions are put aside for cases.hpp. As add() otherwise.
bool add_formula(Context& context, State& state, const std::string& name, const Formula& formula);

/// Brings a fact in; true if the state is contradictory then, its steps end in the contradiction.
bool add(Context& context, State& state, Fact fact);

}  // namespace slipproof::prove
