// Proofs of existence by a witness: values of the unknowns, after which it remains to refute that they fail. The values
// are numbers if the statement has no parameters, otherwise the solution of the conclusion's equations (solution.hpp)
// or a value between bounds (bounds.hpp). Nothing else is tried: a root of a polynomial, without a formula in the
// parameters, is not found.
#pragma once

#include <string>
#include <vector>

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"
#include "proofs/rules/bounds.hpp"

namespace slipproof::prove {

class Existence {
 public:
  /// `close` refutes the goals that remain after the values are stated.
  Existence(Context& context, Close close) : context_(context), close_(std::move(close)) {}

  /// Tries to prove that the unknowns of the statement exist, in a state of its assumptions.
  bool close(State& state) { return close_from(state, 0, 2); }

 private:
  bool close_from(State& state, std::size_t hint, int pivots);
  bool close_by_numbers(State& state);
  bool close_by_solution(State& state);
  bool close_by_alternatives(State& state, int splits);
  bool close_by_bounds(State& state, int splits);
  bool close_by_stronger_bounds(State& state, const Bounds& bounds, int splits);
  bool close_by_witness(State& state, const std::vector<std::string>& values);
  bool close_by_pivot(State& state, std::size_t hint, int pivots);

  const Statement& statement() const { return context_.statement(); }

  Context& context_;
  Close close_;
};

}  // namespace slipproof::prove
