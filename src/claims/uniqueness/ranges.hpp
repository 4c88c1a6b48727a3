// Joins neighbouring values of a parameter that have the same result.
#pragma once

#include <optional>
#include <vector>

#include "claims/uniqueness/along.hpp"

namespace slipproof {

/// Values of the parameter with the same numbers of motions, ordered by load, and the same result for every q. The
/// loads are those at `sample`.
struct ParameterRange {
  std::optional<RealRoot> lower, upper;  ///< nothing: no end
  bool lower_closed = false, upper_closed = false;
  Rational sample;
  MotionsAtParameter motions;
  /// Irrational values in the range, or at its open ends, that were not examined.
  std::vector<RealRoot> unseen;
};

/// The ranges in ascending order; they leave out values outside the domain.
std::vector<ParameterRange> ranges(const UniquenessAlong& along);

}  // namespace slipproof
