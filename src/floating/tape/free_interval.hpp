// Where conditions of a mode hold that leaves one number free, or two: after Fourier and Motzkin, at several points
// side by side.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "floating/tape/running_error.hpp"

namespace slipproof {

/// The sure ends of where conditions alpha + beta t >= 0 hold, and those that are likely.
struct FreeInterval {
  Lanes lower = Lanes{} - HUGE_VAL, upper = Lanes{} + HUGE_VAL;     ///< likely
  Lanes lowest = Lanes{} - HUGE_VAL, highest = Lanes{} + HUGE_VAL;  ///< no t outside

  void cut(const RunningError& root, const LaneBits& from_below, const LaneBits& from_above) {
    const Lanes margin = (root.error + batch_rounding * absolute(root.value)) * batch_slack;
    const Lanes low = root.value - margin, high = root.value + margin;
    lower = chosen(from_below & (root.value > lower), root.value, lower);
    lowest = chosen(from_below & (low > lowest), low, lowest);
    upper = chosen(from_above & (root.value < upper), root.value, upper);
    highest = chosen(from_above & (high < highest), high, highest);
  }

  /// Somewhere inside, if anything is.
  Lanes inside() const {
    const LaneBits has_lower = lower > -HUGE_VAL, has_upper = upper < HUGE_VAL;
    const Lanes above = lower + absolute(lower) + 1, below = upper - absolute(upper) - 1;
    const Lanes one_end = chosen(has_lower, above, chosen(has_upper, below, Lanes{}));
    return chosen(has_lower & has_upper, lower * 0.5 + upper * 0.5, one_end);
  }
};

/// constant + slopes . t >= 0, at the points where that is so.
struct HalfSpace {
  RunningError constant;
  std::array<RunningError, 2> slopes;
  LaneBits asked;
};

inline FreeInterval interval_of(const std::vector<HalfSpace>& sides, std::size_t k) {
  FreeInterval interval;
  for (const HalfSpace& side : sides) {
    const RunningError& slope = side.slopes[k];
    interval.cut(-side.constant / slope, side.asked & surely_positive(slope), side.asked & surely_negative(slope));
  }
  return interval;
}

/// What follows for the second of two free numbers: all of it where the signs of the slopes are sure, and nothing else
/// in any case.
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
