// Limits of a search for a proof.
#pragma once

#include <cstdint>
#include <functional>

namespace slipproof::prove {

struct Limits {
  int split_depth = 3;       ///< nested splits that no hypothesis suggests
  int split_candidates = 6;  ///< candidates tried at each of them
  int slack_depth = 2;       ///< variables replaced together
  int slack_attempts = 400;  ///< attempts for one polynomial
  /// Largest number of products of hypotheses in a linear program; 0: no products. Products of 2, then of 3, are used
  /// after the other rules have failed.
  std::size_t products = 400;
  /// Whether to try sums of squares after all other rules, with half as many steps more; needs the solver, and
  /// `products` > 0.
  bool sums_of_squares = true;
  int instances = 4000;  ///< attempts to find numbers for a statement about some bicycle
  /// Attempts to find numbers at which a statement is false, before (`quick_samples`) and after (`samples`) the search
  /// for a proof. With `samples` = 0, it is also not examined whether the assumptions of a proved statement contradict
  /// each other.
  int quick_samples = 16, samples = 400;
  /// Limit for one statement, in steps of polynomial arithmetic, which are the same on every machine.
  std::uint64_t steps = 100'000'000;
  /// Called about every million steps with their number, to show progress.
  std::function<void(std::uint64_t steps)> tick = {};
};

}  // namespace slipproof::prove
