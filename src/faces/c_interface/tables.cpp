#include <cmath>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "faces/c_interface/solution.hpp"
#include "report/scenes/mechanism_report.hpp"

namespace slipproof::c {

namespace {

/// A range that is one number.
Range exactly(const Rational& x) {
  return {x, x};
}

/// Combines names and ranges.
std::vector<slipproof_value> values(Tables& to, const std::vector<std::string>& names,
                                    const std::vector<Range>& ranges) {
  std::vector<slipproof_value> result;
  for (std::size_t i = 0; i < names.size(); ++i) result.push_back({to.keep(names[i]), to.interval(ranges[i])});
  return result;
}

void put(Tables& to, const Mechanism& mechanism, const MotionsAtLoad& found) {
  std::vector<std::string> names = acceleration_names(mechanism);
  const std::vector<std::string> forces = force_names(mechanism);
  names.insert(names.end(), forces.begin(), forces.end());
  for (const MotionAtLoad& m : found.motions) {
    std::vector<Range> ranges;
    for (const Rational& x : m.accelerations) ranges.push_back(exactly(x));
    ranges.insert(ranges.end(), m.forces.begin(), m.forces.end());
    to.motions.push_back(to.motion(m.all_modes(), m.strict(), false, values(to, names, ranges)));
  }
  for (const ContinuumAtLoad& c : found.continua) {
    std::vector<Range> ranges = c.accelerations;
    ranges.insert(ranges.end(), c.forces.begin(), c.forces.end());
    to.motions.push_back(to.motion({c.mode}, c.strict, true, values(to, names, ranges)));
  }
  for (const RejectedMode& r : found.rejected) {
    to.rejections.push_back({to.keep(name(r.mode)), to.keep(what_is_broken(mechanism, r)),
                             r.margin ? to.keep(exact_text(*r.margin)) : nullptr});
  }
}

}  // namespace

slipproof_interval Tables::interval(const ForceInterval& interval) {
  const auto& [lower, upper] = std::pair(interval.lower(), interval.upper());
  const char* low = lower ? keep(exact_text(*lower)) : nullptr;
  const char* high = !upper ? nullptr : interval.is_point() ? low : keep(exact_text(*upper));
  return {low,
          high,
          lower ? nearest_binary64(*lower) : -HUGE_VAL,
          upper ? nearest_binary64(*upper) : HUGE_VAL,
          interval.lower_closed(),
          interval.upper_closed()};
}

slipproof_interval Tables::interval(const Range& range) {
  return interval(ForceInterval::between(range.lower, range.lower.has_value(), range.upper, range.upper.has_value()));
}

slipproof_motion Tables::motion(const std::vector<MechanismMode>& modes, bool strict, bool continuum,
                                std::vector<slipproof_value> values) {
  auto& names = lists_.emplace_back();
  for (const MechanismMode& mode : modes) names.push_back(keep(slipproof::name(mode)));
  const auto& kept = values_.emplace_back(std::move(values));
  return {names.data(), names.size(), strict, continuum, kept.data(), kept.size()};
}

void Tables::add_cell(const ForceInterval& loads, std::vector<slipproof_motion> of_cell) {
  const auto& kept = cell_motions_.emplace_back(std::move(of_cell));
  cells.push_back({interval(loads), kept.data(), kept.size()});
}

Tables tables(const SolvedMechanism& solved) {
  Tables to;
  to.name = solved.scene.name;
  if (solved.scene.load) to.load = exact_text(*solved.scene.load);
  if (solved.at_load) put(to, solved.scene.mechanism, *solved.at_load);
  for (const ConsistentMode& mode : solved.modes) {
    to.ranges.push_back({to.keep(name(mode.mode)), to.interval(mode.solutions.loads)});
  }
  for (const LoadCell& cell : solved.cells) {
    std::vector<slipproof_motion> motions;
    for (const MotionOverLoads& m : cell.motions) {
      motions.push_back(to.motion(m.modes.empty() ? m.boundary_modes : m.modes, !m.modes.empty(), false));
    }
    for (const MechanismMode& m : cell.continua) motions.push_back(to.motion({m}, false, true));
    to.add_cell(cell.loads, std::move(motions));
  }
  return to;
}

}  // namespace slipproof::c
