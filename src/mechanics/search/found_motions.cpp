#include "mechanics/search/found_motions.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "mechanics/kernel/kinematic_modes.hpp"

namespace slipproof {

std::string_view name(MotionCount count) {
  constexpr std::array<std::string_view, motion_counts> names{"one",       "none",       "none_modelled", "several",
                                                              "continuum", "hysteresis", "undecided"};
  return names[static_cast<std::size_t>(count)];
}

namespace {

std::vector<LoadCell> all_cells(const FrictionProblem& problem) {
  if (problem.has_load) {
    return cells_of(problem, consistent_modes(problem, std::nullopt), Detail::modes);
  }
  return {cell_of(motions_of(problem, std::nullopt))};
}

MotionCount count_of(const LoadCell& cell, bool all_modelled) {
  if (!cell.continua.empty()) return MotionCount::continuum;
  if (cell.motions.size() == 1) return MotionCount::one;
  if (!cell.motions.empty()) return MotionCount::several;
  return all_modelled ? MotionCount::none : MotionCount::none_modelled;
}

FoundMotions found_in(const LoadCell& cell, const std::vector<std::size_t>& not_modelled) {
  FoundMotions found{count_of(cell, not_modelled.empty()), {}, 0, cell.continua, not_modelled, {}};
  for (const MotionOverLoads& motion : cell.motions) {
    if (motion.modes.empty()) {
      ++found.on_boundary;
    } else {
      found.modes.push_back(motion.modes);
      std::sort(found.modes.back().begin(), found.modes.back().end());
    }
  }
  std::sort(found.modes.begin(), found.modes.end());
  std::sort(found.continua.begin(), found.continua.end());
  return found;
}

/// Adds a cell with several motions, cut where one is left in the cells of the problem with lowered coefficients.
void add_parted(const FoundOverLoads& whole, const std::vector<LoadCell>& lowered, std::vector<FoundOverLoads>& all) {
  for (const LoadCell& cell : lowered) {
    FoundOverLoads part = whole;
    part.loads.intersect(cell.loads);
    if (part.loads.empty()) continue;
    if (count_of(cell, true) == MotionCount::one) part.found.count = MotionCount::hysteresis;
    all.push_back(std::move(part));
  }
}

}  // namespace

std::vector<FoundOverLoads> found_over_loads(const FrictionProblem& problem,
                                             const std::vector<std::size_t>& not_modelled, bool hysteresis_apart) {
  std::vector<FoundOverLoads> all;
  std::optional<std::vector<LoadCell>> lowered;
  const auto problem_lowered = hysteresis_apart ? without_hysteresis(problem) : std::nullopt;
  for (const LoadCell& cell : all_cells(problem)) {
    FoundOverLoads whole{found_in(cell, not_modelled), cell.loads};
    if (whole.found.count != MotionCount::several || !problem_lowered) {
      all.push_back(std::move(whole));
      continue;
    }
    if (!lowered) lowered = all_cells(*problem_lowered);
    add_parted(whole, *lowered, all);
  }
  return all;
}

FoundMotions found_outcomes(const FrictionProblem& problem, const std::vector<std::size_t>& not_modelled,
                            const ImpactEnergy& energy) {
  const MotionsAtLoad at = motions_of(problem, std::nullopt);
  FoundMotions found = found_in(cell_of(at), not_modelled);
  const auto add = [&](const Range& after) { found.energy = std::max(found.energy, energy.balance(after)); };
  if (!energy.is_driven()) found.energy = EnergyBalance::not_gained;
  for (const MotionAtLoad& outcome : at.motions) {
    const Rational after = energy.of(outcome.accelerations);
    add({after, after});
  }
  for (const ContinuumAtLoad& outcomes : at.continua) add(energy.of(outcomes.accelerations));
  return found;
}

}  // namespace slipproof
