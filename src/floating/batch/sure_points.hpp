// Decides points of a batch where binary64 is sure: first in blocks that share their error bounds, then side by side.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "base/parallel/stop.hpp"
#include "floating/batch/block_points.hpp"

namespace slipproof {

/// For one thread only. Made once for many batches in which the same columns have one number for each point.
class SurePoints {
 public:
  /// Both must outlive it; the columns may change between the calls.
  SurePoints(const MechanismBatch& batch, const MechanismColumns& columns)
      : batch_(batch), columns_(columns), lanes_(batch, columns) {}

  /// Calls see(point, statuses of all modes, the mode of the only motion or nothing) for each decided point, in any
  /// order.
  template <class See>
  void decide(std::size_t count, const See& see) {
    if (!blocks_ && count >= block_points) blocks_.emplace(batch_, columns_);
    for (std::size_t begin = 0; begin < count; begin += chunk_points) {
      stop_if_asked();
      const std::size_t end = std::min(count, begin + chunk_points);
      left_.clear();
      if (blocks_ && count >= block_points) {
        blocks_->decide(begin, end, see, left_);
      } else {
        for (std::size_t point = begin; point < end; ++point) left_.push_back(point);
      }
      for (std::size_t i = 0; i < left_.size(); i += lane_count) {
        lanes_.decide(std::span(left_).subspan(i, std::min<std::size_t>(lane_count, left_.size() - i)), see);
      }
    }
  }

 private:
  static constexpr std::size_t chunk_points = 256;

  const MechanismBatch& batch_;
  const MechanismColumns& columns_;
  LanePoints lanes_;
  std::optional<BlockPoints> blocks_;
  std::vector<std::size_t> left_;
};

}  // namespace slipproof
