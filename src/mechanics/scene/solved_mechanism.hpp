// A scene of a mechanism with its motions: data, which solve_mechanism.hpp finds.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/kernel/motion.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

struct SolvedMechanism {
  MechanismScene scene;
  FrictionProblem problem;               ///< the problem, its equations solved
  bool by_kinematics = false;            ///< boundary modes of the motions found are missing, and rejected modes
  bool ranges_complete = true;           ///< whether `modes` and `cells` have all modes
  std::vector<ConsistentMode> modes;     ///< modes for all loads; empty for a mechanism without a load
  std::optional<MotionsAtLoad> at_load;  ///< if the load has a value, or the mechanism has no load
  std::vector<LoadCell> cells;           ///< if the load has no value
};

}  // namespace slipproof
