// Points of a batch by blocks that share their error bounds.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "floating/batch/block_modes.hpp"
#include "floating/batch/lane_points.hpp"

namespace slipproof {

/// Decides points in blocks that share their error bounds, while that decides most of them.
class BlockPoints {
 public:
  BlockPoints(const MechanismBatch& batch, const MechanismColumns& columns)
      : programs_(batch.code()->programs()),
        columns_(columns),
        code_(batch.block_code(constant_inputs(programs_, columns))),
        blocks_(code_),
        status_(programs_.programs.size()),
        ranges_(programs_.inputs()) {}

  /// Calls see(point, statuses of all modes, the mode of the only motion or nothing) for each point that is decided;
  /// adds the others to `left`.
  template <class See>
  void decide(std::size_t begin, std::size_t end, const See& see, std::vector<std::size_t>& left) {
    const std::size_t before = left.size();
    if (common_numbers() != common_) ready_ = false;  // ranges are of those
    const bool measured = pause_ == 0 && !ready_;
    if (pause_ > 0 || !(ready_ || measure(begin, end))) {
      pause_ = pause_ > 0 ? pause_ - 1 : next_pause();
      for (std::size_t point = begin; point < end; ++point) left.push_back(point);
      return;
    }
    for (std::size_t first = begin; first < end; first += block_points) {
      decide_block(first, std::min(end, first + block_points), see, left);
    }
    ready_ = 4 * (left.size() - before) <= end - begin;  // otherwise finding new ranges is worth the time
    if (ready_) {
      pauses_ = 1;
    } else if (measured) {
      pause_ = next_pause();
    }
  }

 private:
  /// Of each column the number that all points share, or none, and whether its numbers are exact.
  std::vector<std::pair<double, bool>> common_numbers() const {
    std::vector<std::pair<double, bool>> common;
    const auto take = [&](const Column& column) {
      common.emplace_back(column.varies() || column.size() == 0 ? 0 : column[0], column.exact());
    };
    std::ranges::for_each(columns_.parameters, take);
    std::ranges::for_each(columns_.tan_halves, take);
    take(columns_.load);
    return common;
  }

  /// The range of a column between two points, with room for points that follow.
  static SharedRange range_of(const Column& column, std::size_t begin, std::size_t end) {
    SharedRange range = values_of(column, begin, end);
    if (!column.exact()) range.error += range.size() * batch_rounding + batch_underflow;
    return range;
  }

  static SharedRange values_of(const Column& column, std::size_t begin, std::size_t end) {
    if (!column.varies()) return {column[0], column[0], std::isfinite(column[0]) ? 0 : HUGE_VAL};
    double lower = HUGE_VAL, upper = -HUGE_VAL;
    for (std::size_t i = begin; i < end; ++i) {
      if (!std::isfinite(column[i])) continue;
      lower = std::min(lower, column[i]);
      upper = std::max(upper, column[i]);
    }
    constexpr double room = 1.5;
    if (!(lower <= upper)) return {0, 0, HUGE_VAL};
    return {lower > 0 ? lower / room : lower * room, upper > 0 ? upper * room : upper / room, 0};
  }

  bool measure(std::size_t begin, std::size_t end) {
    common_ = common_numbers();
    for (std::size_t i = 0; i < columns_.parameters.size(); ++i) {
      ranges_[i] = programs_.given[i] ? range_of(columns_.parameters[i], begin, end) : SharedRange{};
    }
    for (std::size_t i = 0; i < columns_.tan_halves.size(); ++i) {
      const auto [cosine, sine] = circle_of(range_of(columns_.tan_halves[i], begin, end), SharedRange{1, 1, 0});
      ranges_[programs_.cosine(i)] = cosine;
      ranges_[programs_.cosine(i) + 1] = sine;
    }
    if (columns_.load.size() > 0) ranges_[programs_.load()] = range_of(columns_.load, begin, end);
    blocks_.set_ranges(ranges_);
    for (std::size_t first = begin; first < end; first += block_points) {
      fill_block(first, std::min(end, first + block_points));
      blocks_.see_results();
    }
    blocks_.find_bounds();
    return blocks_.able();
  }

  std::size_t next_pause() { return pauses_ = std::min<std::size_t>(2 * pauses_, 64); }

  void fill_block(std::size_t first, std::size_t end) {
    const auto fill = [&](std::size_t input, const auto& number) {
      if (code_.constant[input]) return;
      double* const to = blocks_.input(input);
      for (std::size_t i = 0; i < block_points; ++i) to[i] = number(std::min(first + i, end - 1));
    };
    const auto copy = [&](std::size_t input, const Column& column) {
      if (code_.constant[input] || end - first < block_points || column.size() == 1) {
        fill(input, [&](std::size_t point) { return column[point]; });
      } else {
        std::copy_n(column.data() + first, block_points, blocks_.input(input));
      }
    };
    for (std::size_t i = 0; i < columns_.parameters.size(); ++i) copy(i, columns_.parameters[i]);
    for (std::size_t i = 0; i < columns_.tan_halves.size(); ++i) {
      const auto circle = [&](std::size_t point) { return circle_of(columns_.tan_halves[i][point], 1.0); };
      fill(programs_.cosine(i), [&](std::size_t point) { return circle(point).first; });
      fill(programs_.cosine(i) + 1, [&](std::size_t point) { return circle(point).second; });
    }
    copy(programs_.load(), columns_.load);
  }

  template <class See>
  void decide_block(std::size_t first, std::size_t end, const See& see, std::vector<std::size_t>& left) {
    fill_block(first, end);
    blocks_.decide(answers_);
    for (std::size_t point = first; point < end; ++point) {
      if (answers_.left[point - first] < 0) {
        left.push_back(point);
        continue;
      }
      for (std::size_t mode = 0; mode < status_.size(); ++mode) {
        const bool fails = (answers_.inconsistent[mode / 64][point - first] >> (mode % 64) & 1U) != 0;
        status_[mode] = fails                                   ? ModeAt::inconsistent
                        : programs_.programs[mode].never_strict ? ModeAt::boundary
                                                                : ModeAt::strict;
      }
      see(point, std::span<const ModeAt>(status_), only_motion(programs_, status_));
    }
  }

  const ModePrograms& programs_;
  const MechanismColumns& columns_;
  const BlockCode& code_;
  BlockModes blocks_;
  BlockAnswers answers_;
  std::vector<ModeAt> status_;
  std::vector<SharedRange> ranges_;
  std::vector<std::pair<double, bool>> common_;  ///< when the ranges were measured
  bool ready_ = false;
  std::size_t pause_ = 0, pauses_ = 1;
};

}  // namespace slipproof
