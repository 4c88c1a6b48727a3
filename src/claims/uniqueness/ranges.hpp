// Neighbouring values of a parameter of which the same is said, joined.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "claims/uniqueness/along.hpp"

namespace slipproof {

/// Values in which there are the same numbers of motions, from below, and the same is said of every q. The loads are
/// those at `sample`.
struct ParameterRange {
  std::optional<RealRoot> lower, upper;  ///< nothing: no end
  bool lower_closed = false, upper_closed = false;
  Rational sample;
  MotionsAtParameter motions;
  /// Irrational values in it, or at its open ends, which were not looked at.
  std::vector<RealRoot> unseen;
};

/// In their order; values out of the domain are in none.
std::vector<ParameterRange> ranges(const UniquenessAlong& along);

}  // namespace slipproof
