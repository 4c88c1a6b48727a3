// The output of `slipproof simulate`: which of the exact motions are reached by contacts that give.
#pragma once

#include <string>

#include "contact/simulation/simulation.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// For people; `digits` is the number of significant digits of decimals. The status begins with `s SIMULATED`.
Document simulation_document(const MechanismScene& scene, const Simulation& simulation, int digits);

/// One JSON document, schema slipproof/simulate/1. Exact numbers are strings, simulated ones are numbers.
std::string simulation_json(const MechanismScene& scene, const Simulation& simulation);

}  // namespace slipproof
