// Cases that the hypotheses make themselves: disjunctions, each of whose parts is refuted in a branch of its own. They
// wait in the state until the facts alone give nothing more, as every one multiplies the work.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// Forgets disjunctions that are known to be true: their branches have nothing to say.
void drop_known_cases(Context& context, State& state);

/// The index of the disjunction to open next: one without a part that can be true, so that opening it closes the state;
/// otherwise the shortest. There must be one.
struct NextCases {
  std::size_t index = 0;
  bool impossible = false;
};
NextCases next_cases(Context& context, const State& state);

/// Opens the disjunction and closes all its branches, or leaves the state as it was.
bool close_cases(Context& context, State& state, std::size_t index, const Close& close);

}  // namespace slipproof::prove
