// Fourier-Motzkin elimination: two inequalities that are linear in a variable, with coefficients of opposite known
// signs, bound it from below and from above, and together imply an inequality without it. The new inequality is not
// kept, as their number would grow without end; it only counts if the signs of its factors contradict it.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

struct PairsResult {
  bool refuted = false;          ///< the steps of the state end in the contradiction
  std::vector<Polynomial> open;  ///< otherwise: factors whose signs might have made one, as often as they were met
};

PairsResult refute_pairs(Context& context, State& state, Pass pass);

}  // namespace slipproof::prove
