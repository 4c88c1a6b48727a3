// The one motion of a mode as rational functions of a setting's parameters and the force.
//
// The equations of the mode are eliminated over these functions, in lowest terms; a mode whose equations are singular
// for all parameters has no one motion. What is divided by is kept: elsewhere the motion is what the functions say.
#pragma once

#include <vector>

#include "claims/identity/symbolic.hpp"
#include "claims/paper/compiled.hpp"

namespace slipproof {

struct SymbolicMotion {
  bool found = false;  ///< false also where the mode is not modelled, and where the functions grow too large
  std::vector<SymbolicNumber> divisors;
};

/// Gives the quantities of the setting their values in a mode. The evaluator has those of the parameters and the force.
SymbolicMotion symbolic_motion(const CompiledSetting& setting, const MechanismMode& mode, SymbolicEvaluator& paper);

}  // namespace slipproof
