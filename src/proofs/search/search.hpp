// The search for proofs, by refutation: the assumptions and the negated conclusion become facts, and the techniques
// below look for a contradiction between them, the cheap ones first, then again in each open case.
//
//   context, state          shared by all of them; the facts of one branch
//   facts                   new facts in short form: reduction by equations, normal_form by known signs
//   elimination             equations that determine a variable
//   signs, slack            the signs of factors, by substitution of slack variables
//   single_facts            one fact that the others contradict
//   pairs                   Fourier-Motzkin elimination
//   products                linear programming over products of hypotheses
//   cases, splits, squares  case distinctions: those that the hypotheses make, and new ones
//   sums                    sums of squares, where all else has failed and a solver is installed
//   existence               witnesses for `exists`: solution of equations, bounds
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// The open conditions of a failed search, for users.
struct Leftover {
  std::vector<std::string> facts;
  bool exhausted = false;  ///< no step was left
};

/// A search for a proof of a statement, which must outlive it. Deterministic.
class Search {
 public:
  Search(const Statement& statement, const Limits& limits);

  /// Returns a proof that the statement holds, or nothing; then leftover() says where the search got stuck. Takes at
  /// most the steps of the limits.
  std::optional<Proof> prove();
  const Leftover& leftover() const { return leftover_; }
  std::uint64_t steps() const { return steps_; }

 private:
  std::optional<Proof> search();
  std::optional<Proof> search_with_sums();
  std::optional<Proof> search_with_circles();
  bool search_deeper(const State& start, State& closed, int first_depth);
  bool close(State& state, int depth);
  bool close_disjunctions(State& state, int depth);
  bool close_by_splits(State& state, int depth, const std::vector<Polynomial>& open_factors);
  void keep_leftover(const State& state);

  Context context_;
  Leftover leftover_;
  std::uint64_t steps_ = 0;
};

}  // namespace slipproof::prove
