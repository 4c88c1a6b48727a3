// Points of a batch by blocks that share their error bounds.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "floating/tape/block_modes.hpp"
#include "floating/tape/mechanism_batch.hpp"

namespace slipproof {

/// Points by blocks that share their error bounds, as long as that decides most of them.
class BlockPoints {
 public:
  BlockPoints(const ModePrograms& programs, const MechanismColumns& columns, const std::vector<bool>& given)
      : programs_(programs),
        columns_(columns),
        given_(given),
        code_(programs, constant_inputs()),
        blocks_(code_),
        ranges_(programs.inputs()) {}

  /// see(point, mode, status) of the points that are decided; the others are added to `left`.
  template <class See>
  void decide(std::size_t begin, std::size_t end, const See& see, std::vector<std::size_t>& left) {
    const std::size_t before = left.size();
    if (pause_ > 0 || !(ready_ || measure(begin, end))) {
      pause_ = pause_ > 0 ? pause_ - 1 : next_pause();
      for (std::size_t point = begin; point < end; ++point) left.push_back(point);
      return;
    }
    for (std::size_t first = begin; first < end; first += block_points) {
      decide_block(first, std::min(end, first + block_points), see, left);
    }
    ready_ = 4 * (left.size() - before) <= end - begin;  // or new ranges are worth their time
    if (ready_) {
      pauses_ = 1;
    } else if (measured_at_ == begin) {
      pause_ = next_pause();
    }
  }

 private:
  std::vector<bool> constant_inputs() const {
    std::vector<bool> constant(programs_.inputs(), true);
    for (std::size_t i = 0; i < columns_.parameters.size(); ++i) constant[i] = columns_.parameters[i].size() <= 1;
    for (std::size_t i = 0; i < columns_.tan_halves.size(); ++i) {
      constant[programs_.cosine(i)] = constant[programs_.cosine(i) + 1] = columns_.tan_halves[i].size() <= 1;
    }
    constant[programs_.load()] = columns_.load.size() <= 1;
    return constant;
  }

  /// Of a column between two points, with room for those that follow.
  static SharedRange range_of(const Column& column, std::size_t begin, std::size_t end) {
    if (column.size() <= 1) return {column[0], column[0], std::isfinite(column[0]) ? 0 : HUGE_VAL};
    double lower = HUGE_VAL, upper = -HUGE_VAL;
    for (std::size_t i = begin; i < end; ++i) {
      if (!std::isfinite(column[i])) continue;
      lower = std::min(lower, column[i]);
      upper = std::max(upper, column[i]);
    }
    constexpr double room = 1.125;
    if (!(lower <= upper)) return {0, 0, HUGE_VAL};
    return {lower > 0 ? lower / room : lower * room, upper > 0 ? upper * room : upper / room, 0};
  }

  bool measure(std::size_t begin, std::size_t end) {
    measured_at_ = begin;
    for (std::size_t i = 0; i < columns_.parameters.size(); ++i) {
      ranges_[i] = given_[i] ? range_of(columns_.parameters[i], begin, end) : SharedRange{};
    }
    for (std::size_t i = 0; i < columns_.tan_halves.size(); ++i) {
      const auto [cosine, sine] = circle_of(range_of(columns_.tan_halves[i], begin, end), SharedRange{1, 1, 0});
      ranges_[programs_.cosine(i)] = cosine;
      ranges_[programs_.cosine(i) + 1] = sine;
    }
    if (columns_.load.size() > 0) ranges_[programs_.load()] = range_of(columns_.load, begin, end);
    blocks_.set_ranges(ranges_);
    return blocks_.able();
  }

  std::size_t next_pause() { return pauses_ = std::min<std::size_t>(2 * pauses_, 64); }

  template <class See>
  void decide_block(std::size_t first, std::size_t end, const See& see, std::vector<std::size_t>& left) {
    const auto fill = [&](std::size_t input, const auto& number) {
      if (code_.constant[input]) return;
      double* const to = blocks_.input(input);
      for (std::size_t i = 0; i < block_points; ++i) to[i] = number(std::min(first + i, end - 1));
    };
    for (std::size_t i = 0; i < columns_.parameters.size(); ++i) {
      fill(i, [&](std::size_t point) { return columns_.parameters[i][point]; });
    }
    for (std::size_t i = 0; i < columns_.tan_halves.size(); ++i) {
      const auto circle = [&](std::size_t point) { return circle_of(columns_.tan_halves[i][point], 1.0); };
      fill(programs_.cosine(i), [&](std::size_t point) { return circle(point).first; });
      fill(programs_.cosine(i) + 1, [&](std::size_t point) { return circle(point).second; });
    }
    fill(programs_.load(), [&](std::size_t point) { return columns_.load[point]; });
    blocks_.decide(answers_);
    for (std::size_t point = first; point < end; ++point) {
      if (answers_.left[point - first] < 0) {
        left.push_back(point);
        continue;
      }
      for (std::size_t mode = 0; mode < programs_.programs.size(); ++mode) {
        const bool fails = (answers_.inconsistent[mode / 64][point - first] >> (mode % 64) & 1U) != 0;
        see(point, mode,
            fails                                   ? ModeAt::inconsistent
            : programs_.programs[mode].never_strict ? ModeAt::boundary
                                                    : ModeAt::strict);
      }
    }
  }

  const ModePrograms& programs_;
  const MechanismColumns& columns_;
  const std::vector<bool>& given_;
  BlockCode code_;
  BlockModes blocks_;
  BlockAnswers answers_;
  std::vector<SharedRange> ranges_;
  bool ready_ = false;
  std::size_t measured_at_ = 0, pause_ = 0, pauses_ = 1;
};

}  // namespace slipproof
