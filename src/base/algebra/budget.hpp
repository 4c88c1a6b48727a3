// A limit for work with polynomials, in steps: the same on every machine, as time is not.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

#include "base/parallel/stop.hpp"

namespace slipproof {

/// Counts steps. Throws Spent when the limit is exceeded, and Stopped when a stop was requested.
class Budget {
 public:
  struct Spent {};

  /// A budget without a limit.
  Budget() = default;
  explicit Budget(std::uint64_t steps) : limit_(steps) {}

  /// Allows this many steps from now on.
  void renew(std::uint64_t steps) {
    limit_ = steps;
    spent_ = 0;
    next_tick_ = tick_distance;
  }
  void lift() { limit_ = std::numeric_limits<std::uint64_t>::max(); }

  void spend(std::size_t steps) {
    spent_ += steps;
    if (spent_ > limit_) throw Spent{};
    stop_if_asked();
    if (spent_ < next_tick_) return;
    next_tick_ = spent_ + tick_distance;
    if (tick_) tick_(spent_);
  }
  /// Calls `tick` about every million steps.
  void watch(std::function<void(std::uint64_t)> tick) { tick_ = std::move(tick); }
  std::uint64_t spent() const { return spent_; }
  std::size_t left() const { return static_cast<std::size_t>(limit_ - std::min(limit_, spent_)); }

 private:
  static constexpr std::uint64_t tick_distance = 1'000'000;

  std::uint64_t limit_ = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t spent_ = 0, next_tick_ = tick_distance;
  std::function<void(std::uint64_t)> tick_;
};

}  // namespace slipproof
