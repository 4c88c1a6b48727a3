// Bounds for an unknown that the conclusion's equations leave free: its inequalities, where they are linear in it with
// a coefficient of known sign. A value between all lower and all upper bounds would do, and which of them are the
// strongest is not known for all parameters: so the middles of pairs are tried, in cases by what bound is the stronger
// one. Where a condition allows equality its bound itself is tried, too: at the edge of a friction cone.
#pragma once

#include <vector>

#include "proofs/branch/state.hpp"
#include "proofs/rules/quotient.hpp"

namespace slipproof::prove {

struct Bounds {
  std::vector<Quotient> lower, upper;
  std::vector<Quotient> attained;  ///< those of either side that the unknown may take

  bool empty() const { return lower.empty() && upper.empty(); }
  /// Values to try: between a lower and an upper bound, or beyond all that there are on one side; then bounds.
  std::vector<Quotient> candidates(const Ring& ring) const;

 private:
  std::vector<Quotient> between_or_beyond(const Ring& ring) const;
};

/// The bounds that the conclusion implies for the unknown `free`, given values of all others.
Bounds bounds_of(Context& context, State& state, std::size_t free, const std::vector<Quotient>& values);

}  // namespace slipproof::prove
