#include "mechanics/kernel/motion.hpp"

#include <algorithm>
#include <iterator>

namespace slipproof {

namespace {

std::vector<MechanismMode> joined(std::vector<MechanismMode> modes, const std::vector<MechanismMode>& more) {
  modes.insert(modes.end(), more.begin(), more.end());
  return modes;
}

}  // namespace

std::vector<MechanismMode> MotionAtLoad::all_modes() const {
  return joined(modes, boundary_modes);
}

std::vector<MechanismMode> MotionOverLoads::all_modes() const {
  return joined(modes, boundary_modes);
}

LoadCell cell_of(const MotionsAtLoad& found) {
  LoadCell cell;
  for (const MotionAtLoad& motion : found.motions) {
    cell.motions.push_back({motion.modes, motion.boundary_modes, {}, {}, motion.continua});
  }
  for (const ContinuumAtLoad& continuum : found.continua) cell.continua.push_back(continuum.mode);
  return cell;
}

std::vector<MechanismMode> modes_in(const MotionsAtLoad& found, const ContinuumAtLoad& continuum) {
  std::vector<MechanismMode> inside;
  for (const MotionAtLoad& motion : found.motions) {
    if (std::ranges::find(motion.continua, continuum.mode) != motion.continua.end())
      std::ranges::move(motion.all_modes(), std::back_inserter(inside));
  }
  return inside;
}

}  // namespace slipproof
