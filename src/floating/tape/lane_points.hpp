// Points of a batch side by side, each with error bounds of its own.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "floating/tape/mechanism_batch.hpp"
#include "floating/tape/mode_run.hpp"

namespace slipproof {

/// Of one thread.
class LanePoints {
 public:
  LanePoints(const ModeCode& code, const MechanismColumns& columns, const std::vector<bool>& given)
      : programs_(code.programs()), columns_(columns), given_(given), run_(code) {}

  /// `points`: at most lane_count. Whether each is decided, mode by mode.
  template <class See>
  void decide(std::span<const std::size_t> points, const See& see) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) put(points[std::min(lane, points.size() - 1)], lane);
    run_.decide();
    for (std::size_t lane = 0; lane < points.size(); ++lane) {
      for (std::size_t mode = 0; mode < run_.modes().size(); ++mode) see(points[lane], mode, at(mode, lane));
    }
  }

 private:
  void put(std::size_t point, std::size_t lane) {
    for (std::size_t i = 0; i < columns_.parameters.size(); ++i) {
      run_.set(i, lane, given_[i] ? columns_.parameters[i][point] : 0);
    }
    for (std::size_t i = 0; i < columns_.tan_halves.size(); ++i) run_.set_angle(i, lane, columns_.tan_halves[i][point]);
    run_.set(programs_.load(), lane, columns_.load.size() > 0 ? columns_.load[point] : 0);
  }

  ModeAt at(std::size_t mode, std::size_t lane) const {
    const LaneModes& found = run_.modes()[mode];
    return found.strict[lane] != 0         ? ModeAt::strict
           : found.boundary[lane] != 0     ? ModeAt::boundary
           : found.inconsistent[lane] != 0 ? ModeAt::inconsistent
                                           : ModeAt::unsure;
  }

  const ModePrograms& programs_;
  const MechanismColumns& columns_;
  const std::vector<bool>& given_;
  ModeRun run_;
};

}  // namespace slipproof
