// The output of `slipproof simulate`: which of the exact motions are reached by contacts that give.
#pragma once

#include <string>

#include "contact/simulation/simulation.hpp"

namespace slipproof {

/// For people; `digits` is the number of significant digits of decimals. The last line begins with `s SIMULATED`.
std::string simulation_text(const MechanismScene& scene, const Simulation& simulation, int digits);

/// One JSON document, schema slipproof/simulate/1. Exact numbers are strings, simulated ones are numbers.
std::string simulation_json(const MechanismScene& scene, const Simulation& simulation);

}  // namespace slipproof
