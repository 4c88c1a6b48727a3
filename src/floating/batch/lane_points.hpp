// Decides points of a batch side by side, each with its own error bounds.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "floating/batch/block_lanes.hpp"
#include "floating/batch/mechanism_batch.hpp"
#include "floating/tape/mode_run.hpp"

namespace slipproof {

/// Of a mechanism's inputs, whether each is the same for all points.
inline std::vector<bool> constant_inputs(const ModePrograms& programs, const MechanismColumns& columns) {
  std::vector<bool> constant(programs.inputs(), true);
  for (std::size_t i = 0; i < columns.parameters.size(); ++i) constant[i] = !columns.parameters[i].varies();
  for (std::size_t i = 0; i < columns.tan_halves.size(); ++i) {
    constant[programs.cosine(i)] = constant[programs.cosine(i) + 1] = !columns.tan_halves[i].varies();
  }
  constant[programs.load()] = !columns.load.varies();
  return constant;
}

/// As ModeRun::only_motion(), of a point at which all modes are known.
inline std::optional<std::size_t> only_motion(const ModePrograms& programs, std::span<const ModeAt> status) {
  const auto mode = static_cast<std::size_t>(std::ranges::find(status, ModeAt::strict) - status.begin());
  if (mode == status.size() || !programs.programs[mode].determined) return std::nullopt;
  for (std::size_t i = 0; i < status.size(); ++i) {
    const bool other = programs.programs[i].motion != programs.programs[mode].motion;
    if (status[i] == ModeAt::unsure || (other && status[i] != ModeAt::inconsistent)) return std::nullopt;
  }
  return mode;
}

/// The numbers of a point into a lane of a ModeRun, or of BlockLanes.
template <class Run>
void put_point(const MechanismColumns& columns, const ModePrograms& programs, std::size_t point, std::size_t lane,
               Run& run) {
  for (std::size_t i = 0; i < columns.parameters.size(); ++i) {
    const Column& column = columns.parameters[i];
    run.set(i, lane, programs.given[i] ? column[point] : 0, column.exact());
  }
  for (std::size_t i = 0; i < columns.tan_halves.size(); ++i) {
    run.set_angle(i, lane, columns.tan_halves[i][point], columns.tan_halves[i].exact());
  }
  run.set(programs.load(), lane, columns.load.size() > 0 ? columns.load[point] : 0, columns.load.exact());
}

/// Of one thread. First all modes by the code for single points; then, where that leaves something open, by the code of
/// blocks, so that a point has the same answer alone as in a block.
class LanePoints {
 public:
  LanePoints(const MechanismBatch& batch, const MechanismColumns& columns)
      : programs_(batch.code()->programs()),
        columns_(columns),
        run_(*batch.code()),
        blocks_(batch.block_code(constant_inputs(programs_, columns))),
        status_(programs_.programs.size()) {}

  /// `points`: at most lane_count. Calls see(point, statuses of all modes, the mode of the only motion or nothing).
  template <class See>
  void decide(std::span<const std::size_t> points, const See& see) {
    for_each_lane(points, run_);
    run_.decide();
    bool by_blocks = false;
    for (std::size_t lane = 0; lane < points.size(); ++lane) {
      fill_status(lane);
      const bool open = std::ranges::find(status_, ModeAt::unsure) != status_.end();
      auto mode = run_.in_load_domain()[lane] != 0 ? run_.only_motion(lane) : std::nullopt;
      if (open || !mode) {
        if (!by_blocks) {
          for_each_lane(points, blocks_);
          blocks_.decide();
          by_blocks = true;
        }
        join_status(lane);
        if (!mode && blocks_.in_domain()[lane] != 0) mode = only_motion(programs_, status_);
      }
      see(points[lane], std::span<const ModeAt>(status_), mode);
    }
  }

 private:
  template <class Run>
  void for_each_lane(std::span<const std::size_t> points, Run& run) const {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      put_point(columns_, programs_, points[std::min(lane, points.size() - 1)], lane, run);
    }
  }

  void fill_status(std::size_t lane) {
    for (std::size_t mode = 0; mode < status_.size(); ++mode) {
      const LaneModes& found = run_.modes()[mode];
      status_[mode] = found.strict[lane] != 0         ? ModeAt::strict
                      : found.boundary[lane] != 0     ? ModeAt::boundary
                      : found.inconsistent[lane] != 0 ? ModeAt::inconsistent
                                                      : ModeAt::unsure;
    }
  }

  void join_status(std::size_t lane) {
    for (std::size_t mode = 0; mode < status_.size(); ++mode) {
      if (status_[mode] != ModeAt::unsure) continue;
      const SureModes& found = blocks_.modes()[mode];
      if (found.inconsistent[lane] != 0) status_[mode] = ModeAt::inconsistent;
      if (found.holds[lane] != 0) {
        status_[mode] = programs_.programs[mode].never_strict ? ModeAt::boundary : ModeAt::strict;
      }
    }
  }

  const ModePrograms& programs_;
  const MechanismColumns& columns_;
  ModeRun run_;
  BlockLanes blocks_;
  std::vector<ModeAt> status_;
};

}  // namespace slipproof
