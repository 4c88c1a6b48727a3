// Many scenes at once, as a structure of arrays.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "floating/filter/filter.hpp"
#include "floating/filter/lane_numbers.hpp"
#include "floating/filter/vector_kernel.hpp"

namespace slipproof {

/// One number of each scene: an array that outlives it, or a number that is the same for all. Scenes are written down
/// by names, each number in the form it has:
///   const ForcedScene<Column> scenes{
///       .bicycle = {.M = 94, .R = 0.3, .h = heights, .b2 = 0.34, .b3 = 0.68, .I1 = 0.01, .I2 = 0.12, .I3 = 0.2,
///                   .r1 = 0.09, .r2 = 0.036, .L = 0.17, .J = 15.7},
///       .road = {.f = 0.8, .g = 9.81},
///       .F = forces};
class Column {
 public:
  Column() = default;  ///< nothing given: no batch can be decided with it
  Column(double of_all) : of_all_(of_all), size_(1) {}
  Column(std::span<const double> values)
      : of_all_(values.size() == 1 ? values[0] : 0), values_(values.data()), size_(values.size()) {}
  Column(const std::vector<double>& values) : Column(std::span<const double>(values)) {}
  Column(std::vector<double>&&) = delete;

  /// 1: the same for all.
  std::size_t size() const { return size_; }
  double operator[](std::size_t scene) const { return size_ == 1 ? of_all_ : values_[scene]; }
  /// The numbers themselves, where there is one for each scene.
  const double* data() const { return values_; }

 private:
  double of_all_ = 0;
  const double* values_ = nullptr;
  std::size_t size_ = 0;
};

/// consistent_modes() of every scene, the numbers taken exactly. All columns have the length of `answers`, or 1; throws
/// std::invalid_argument otherwise. `threads`: 0 for all there are. Adds to `counts` which tier decided how many
/// scenes. Allocates only where a scene needs the exact tier or a second thread. Answers and counts are the same in all
/// registers; those named have to be available().
void consistent_modes(const ForcedScene<Column>& scenes, std::span<ConsistentModes> answers, TierCounts& counts,
                      unsigned threads = 1, Registers registers = widest_registers());

/// filter_modes() of scenes side by side, all modes of a scene undecided if one is. Scenes beyond the limit of a number
/// are left undecided, those beyond the limit of their sum may be decided.
void filter_lanes(const ForcedScene<LaneNumbers>& scenes, std::array<ModeSets, lane_count>& sets);

/// An answer for each scene, and which tier decided how many.
struct BatchAnswers {
  std::vector<ConsistentModes> modes;
  TierCounts tiers{};
};

/// The same for as many scenes as the longest column has numbers.
BatchAnswers consistent_modes(const ForcedScene<Column>& scenes, unsigned threads = 0);

}  // namespace slipproof
