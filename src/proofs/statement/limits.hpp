// How far a search for a proof goes.
#pragma once

#include <cstdint>
#include <functional>

namespace slipproof::prove {

struct Limits {
  int split_depth = 3;       ///< nested splits that no hypothesis asks for
  int split_candidates = 6;  ///< tried at each of them
  int slack_depth = 2;       ///< variables replaced at a time
  int slack_attempts = 400;  ///< for one polynomial
  /// In a linear program over products of hypotheses; 0: none. Products of 2, then of 3, where all else fails.
  std::size_t products = 400;
  /// Where all that ends without a proof, sums of squares, for half as many steps more, if the solver is installed and
  /// there may be products.
  bool sums_of_squares = true;
  int instances = 4000;  ///< attempts to find numbers for a statement about some bicycle
  /// Attempts to find numbers at which a statement is false, before and after the search for a proof; with none of the
  /// latter it is not asked either whether the assumptions of what is proved contradict each other.
  int quick_samples = 16, samples = 400;
  /// For one statement, in steps of polynomial arithmetic: the same on every machine, as time is not.
  std::uint64_t steps = 100'000'000;
  /// Called every million steps or so with their number; a sign of life.
  std::function<void(std::uint64_t steps)> tick = {};
};

}  // namespace slipproof::prove
