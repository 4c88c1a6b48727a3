// The only motion in a mode, as rational functions of a setting's parameters and the force.
//
// The equations of the mode are eliminated over these functions, in lowest terms. A mode whose equations are singular
// for all parameters has no such motion. All divisors are kept: where none vanishes, the functions give the motion.
#pragma once

#include <vector>

#include "claims/identity/symbolic.hpp"
#include "claims/paper/compiled.hpp"

namespace slipproof {

struct SymbolicMotion {
  bool found = false;  ///< false also if the mode is not modelled, or if the functions become too large
  std::vector<SymbolicNumber> divisors;
};

/// Assigns values in a mode to the quantities of the setting. The evaluator must have values for the parameters and the
/// force.
SymbolicMotion symbolic_motion(const CompiledSetting& setting, const MechanismMode& mode, SymbolicEvaluator& paper);

}  // namespace slipproof
