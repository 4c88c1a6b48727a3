#include "mechanics/kernel/motion.hpp"

#include <algorithm>
#include <iterator>

namespace slipproof {

std::vector<MechanismMode> MotionAtLoad::all_modes() const {
  std::vector<MechanismMode> all = modes;
  all.insert(all.end(), boundary_modes.begin(), boundary_modes.end());
  return all;
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
