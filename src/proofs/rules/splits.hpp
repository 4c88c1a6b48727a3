// Case splits on the sign of a polynomial, < 0, = 0 and > 0, that no hypothesis requires. For any polynomial the three
// cases are complete; the art is in the choice. The candidates here are factors of facts, pivots of equations and the
// statement's hints, or, when all of these failed, variables and their differences.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// Like Close; also receives the fact with which the branch begins.
using CloseSigned = std::function<bool(State& branch, const Fact& sign)>;

/// Closes all three branches, or leaves the state as it was.
bool close_split(Context& context, State& state, const Polynomial& p, const Close& close);
bool close_split(Context& context, State& state, const Polynomial& p, const CloseSigned& close);

/// Polynomials whose sign would help, the most promising first: hints, pivots, factors of facts, and `open` factors
/// whose signs the comparison of pairs needs.
std::vector<Polynomial> split_candidates(Context& context, const State& state, const std::vector<Polynomial>& open);

/// Variables of unknown sign, and differences of variables: the order of a, b, c decides much that is symmetric in
/// them.
std::vector<Polynomial> plain_candidates(Context& context, State& state);

}  // namespace slipproof::prove
