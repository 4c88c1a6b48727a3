// Numbers of several scenes side by side, in memory.
#pragma once

#include <array>

namespace slipproof {

inline constexpr int lane_count = 8;

/// A number of each scene, aligned for the widest registers.
struct alignas(64) LaneNumbers {
  std::array<double, lane_count> of{};
};

}  // namespace slipproof
