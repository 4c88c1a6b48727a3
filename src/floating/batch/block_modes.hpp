// The modes of a mechanism at many points. Answers only where binary64 is sure of all modes, so that error bounds are
// computed once for many points.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "floating/batch/block_code.hpp"

namespace slipproof {

/// The number of points that are computed side by side.
inline constexpr std::size_t block_points = 64;

/// For each point, whether it is left or decided; for decided points which modes are strict, 64 modes in a word.
struct BlockAnswers {
  alignas(64) std::array<std::int64_t, block_points> left;  ///< negative: the point is left undecided
  std::vector<std::array<std::uint64_t, block_points>> inconsistent;
};

/// Runs code over blocks of points. For one thread only.
class BlockModes {
 public:
  explicit BlockModes(const BlockCode& code);

  /// The numbers of an input for the next block.
  double* input(std::size_t index) { return &numbers_[index * block_points]; }

  /// Sets the range of each input over all points that follow; for a constant input, the number itself.
  void set_ranges(std::span<const SharedRange> inputs);
  /// Records the results at the points of a block that are typical of those that follow; they narrow ranges.
  void see_results();
  /// Computes the error bounds, using the recorded results.
  void find_bounds();
  /// Whether binary64 can be sure of anything.
  bool able() const { return able_; }

  /// Decides all points of the block; leaves those outside the ranges.
  void decide(BlockAnswers& answers);

 private:
  friend struct DecideModes;
  friend struct SeeResults;
  void run_narrowed(const TapeCode& code);
  bool find_domain();
  bool find_mode(std::size_t index);

  /// For a result: the range of the values seen; later the range in which it must lie, if that is checked.
  struct ResultRange {
    double lower = std::numeric_limits<double>::infinity(), upper = -lower;
    bool asked = false;
  };

  /// A check of a number at each point: that it is positive, that its negative is positive, or that it is not 0.
  struct Check {
    enum class Sign : std::uint8_t { positive, negative, any };
    std::uint32_t number = 0;
    Sign sign = Sign::positive;
    double error = 0;
  };
  bool add_check(std::uint32_t number, Check::Sign sign, std::vector<Check>& checks) const;

  const BlockCode* code_;
  std::vector<SharedRange> inputs_, shared_;
  std::vector<Check> domain_;         ///< where the ranges leave it open
  std::vector<ResultRange> results_;  ///< of the steps of the domain and all modes
  std::size_t next_result_ = 0;
  struct Bounds {
    double divisor = 0, conditions = 0;
  };
  std::vector<Bounds> bounds_;              ///< by mode
  std::vector<std::vector<Check>> pivots_;  ///< by mode: the checks of pivots that the ranges do not settle
  bool able_ = false;
  std::unique_ptr<double[]> memory_;
  double* numbers_;
};

}  // namespace slipproof
