// Solved scenes in the form of the C interface: arrays of plain structures, and the texts that they point to.
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "contact/problem/every_push.hpp"
#include "faces/c_interface/slipproof.h"
#include "mechanics/scene/solve_mechanism.hpp"

namespace slipproof::c {

/// Owns everything that a solution gives out. Nothing in it moves after it is written.
class Tables {
 public:
  std::string name;
  std::optional<std::string> load;
  std::vector<slipproof_motion> motions;
  std::vector<slipproof_rejection> rejections;
  std::vector<slipproof_range> ranges;
  std::vector<slipproof_cell> cells;

  const char* keep(std::string text) { return texts_.emplace_back(std::move(text)).c_str(); }
  slipproof_interval interval(const ForceInterval& interval);
  slipproof_interval interval(const Range& range);
  /// `values` are the numbers of a motion at a load.
  slipproof_motion motion(const std::vector<MechanismMode>& modes, bool strict, bool continuum,
                          std::vector<slipproof_value> values = {});
  void add_cell(const ForceInterval& loads, std::vector<slipproof_motion> motions);

 private:
  std::deque<std::string> texts_;
  std::deque<std::vector<const char*>> lists_;
  std::deque<std::vector<slipproof_value>> values_;
  std::deque<std::vector<slipproof_motion>> cell_motions_;
};

Tables tables(const SolvedMechanism& solved);

}  // namespace slipproof::c

struct slipproof_solution {
  explicit slipproof_solution(slipproof::MechanismScene scene)
      : solved(solve_mechanism(std::move(scene))),
        every_q(for_every_push(solved.problem)),
        tables(slipproof::c::tables(solved)) {}

  const slipproof::SolvedMechanism solved;
  const std::optional<slipproof::EveryLoad> every_q;
  const slipproof::c::Tables tables;
  mutable std::once_flag json_written;
  mutable std::string json;
};
