// Where the conditions of a mode with one or two free numbers hold, by the method of Fourier and Motzkin, at several
// points side by side.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "floating/tape/running_error.hpp"

namespace slipproof {

/// Sure and likely ends of the interval in which conditions alpha + beta t >= 0 hold. Aligned as RunningError is.
struct FreeInterval {
  alignas(sizeof(Lanes)) Lanes lower = Lanes{} - HUGE_VAL;  ///< likely, like `upper`
  alignas(sizeof(Lanes)) Lanes upper = Lanes{} + HUGE_VAL;
  alignas(sizeof(Lanes)) Lanes lowest = Lanes{} - HUGE_VAL;  ///< surely no t is below `lowest` or above `highest`
  alignas(sizeof(Lanes)) Lanes highest = Lanes{} + HUGE_VAL;

  void cut(const RunningError& root, const LaneBits& from_below, const LaneBits& from_above) {
    const Lanes margin = (root.error + batch_rounding * absolute(root.value)) * bound_inflation;
    const Lanes low = root.value - margin, high = root.value + margin;
    lower = chosen(from_below & (root.value > lower), root.value, lower);
    lowest = chosen(from_below & (low > lowest), low, lowest);
    upper = chosen(from_above & (root.value < upper), root.value, upper);
    highest = chosen(from_above & (high < highest), high, highest);
  }

  /// A number inside the interval, if it has any.
  Lanes inside() const {
    const LaneBits has_lower = lower > -HUGE_VAL, has_upper = upper < HUGE_VAL;
    const Lanes above = lower + absolute(lower) + 1, below = upper - absolute(upper) - 1;
    const Lanes one_end = chosen(has_lower, above, chosen(has_upper, below, Lanes{}));
    return chosen(has_lower & has_upper, lower * 0.5 + upper * 0.5, one_end);
  }
};

/// constant + slopes . t >= 0, at the points where this condition applies.
struct HalfSpace {
  RunningError constant;
  std::array<RunningError, 2> slopes;
  alignas(sizeof(LaneBits)) LaneBits asked;
};

inline FreeInterval interval_of(const std::vector<HalfSpace>& sides, std::size_t k) {
  FreeInterval interval;
  for (const HalfSpace& side : sides) {
    const RunningError& slope = side.slopes[k];
    interval.cut(-side.constant / slope, side.asked & surely_positive(slope), side.asked & surely_negative(slope));
  }
  return interval;
}

/// The conditions that follow for the second of two free numbers. Where the signs of the slopes are sure these are all
/// that follow; elsewhere some may be missing, but none is added.
inline std::vector<HalfSpace> without_first(const std::vector<HalfSpace>& sides) {
  std::vector<HalfSpace> result;
  for (const HalfSpace& x : sides) {
    result.push_back({x.constant, {RunningError{}, x.slopes[1]}, surely_zero(x.slopes[0])});
    for (const HalfSpace& y : sides) {
      const LaneBits opposite = surely_positive(x.slopes[0]) & surely_negative(y.slopes[0]);
      result.push_back({x.slopes[0] * y.constant - y.slopes[0] * x.constant,
                        {RunningError{}, x.slopes[0] * y.slopes[1] - y.slopes[0] * x.slopes[1]},
                        opposite});
    }
  }
  return result;
}

}  // namespace slipproof
