// The deterministic limit of a search.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace slipproof::prove {

/// Counts steps, and ends the search by throwing Spent where there are too many.
class Budget {
 public:
  struct Spent {};

  explicit Budget(std::uint64_t steps) : limit_(steps) {}

  void spend(std::size_t steps) {
    spent_ += steps;
    if (spent_ > limit_) throw Spent{};
  }
  std::uint64_t spent() const { return spent_; }
  std::size_t left() const { return static_cast<std::size_t>(limit_ - std::min(limit_, spent_)); }

 private:
  std::uint64_t limit_;
  std::uint64_t spent_ = 0;
};

}  // namespace slipproof::prove
