// The code of blocks at points side by side, each with error bounds of its own. They are not above those that a block
// shares, as both run the same steps: what a block is sure of, its points are sure of alone.
#pragma once

#include <vector>

#include "floating/batch/block_code.hpp"
#include "floating/tape/truth.hpp"

namespace slipproof {

/// A mode at the points of a run.
struct SureModes {
  alignas(sizeof(LaneBits)) LaneBits inconsistent{};
  alignas(sizeof(LaneBits)) LaneBits holds{};  ///< all conditions that are not 0 at all points hold strictly
};

/// Of one thread; the code must outlive it.
class BlockLanes {
 public:
  explicit BlockLanes(const BlockCode& code);

  /// As ModeRun has it.
  void set(std::size_t input, std::size_t lane, double value, bool exact);
  void set_angle(std::size_t angle, std::size_t lane, double tan_half, bool exact);

  void decide();
  const std::vector<SureModes>& modes() const { return modes_; }
  /// Points surely in the domain, and in that of the load.
  const LaneBits& in_domain() const { return in_domain_; }

 private:
  friend struct BlockLanesKernel;
  void find_domain();
  SureModes judge(const BlockMode& mode) const;

  const BlockCode* code_;
  std::vector<RunningError> numbers_, tan_halves_;
  std::vector<SureModes> modes_;
  alignas(sizeof(LaneBits)) LaneBits in_domain_{};
};

}  // namespace slipproof
