// The modes of a mechanism at many points, as far as binary64 is sure of all of them: nothing else is asked of it, so
// that error bounds are computed once for many points.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "floating/tape/block_code.hpp"

namespace slipproof {

/// As many points are computed side by side.
inline constexpr std::size_t block_points = 64;

/// Points are decided, or left; of those decided which modes are strict, 64 in a word.
struct BlockAnswers {
  alignas(64) std::array<std::int64_t, block_points> left;  ///< negative: nothing is said
  std::vector<std::array<std::uint64_t, block_points>> inconsistent;
};

/// Runs code over blocks. Of one thread.
class BlockModes {
 public:
  explicit BlockModes(const BlockCode& code);

  /// The numbers of an input for the next block.
  double* input(std::size_t index) { return &numbers_[index * block_points]; }

  /// What all points that follow have in common: input by input the range, of constant ones the number itself.
  void set_ranges(std::span<const SharedRange> inputs);
  /// Whether binary64 can be sure of anything.
  bool able() const { return able_; }

  /// All of a block; points outside of the ranges are left.
  void decide(BlockAnswers& answers);

 private:
  friend struct DecideModes;
  bool find_bounds();
  bool find_domain();
  bool find_mode(std::size_t index);

  /// What is asked of a number at each point: positive, or negated so, or not 0.
  struct Check {
    enum class Sign : std::uint8_t { positive, negative, any };
    std::uint32_t number = 0;
    Sign sign = Sign::positive;
    double error = 0;
  };
  bool add_check(std::uint32_t number, Check::Sign sign, std::vector<Check>& checks) const;

  const BlockCode* code_;
  std::vector<SharedRange> inputs_, shared_;
  std::vector<Check> domain_;               ///< where the ranges leave it open
  std::vector<double> bounds_;              ///< of each mode
  std::vector<std::vector<Check>> pivots_;  ///< of each mode, where the ranges leave them open
  bool able_ = false;
  std::unique_ptr<double[]> memory_;
  double* numbers_;
};

}  // namespace slipproof
