// What `slipproof simulate` says: which of the exact motions contacts that give come to.
#pragma once

#include <string>

#include "contact/simulation/simulation.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// For people; `digits` is how many significant ones a decimal has. The status begins with `s SIMULATED`.
Document simulation_document(const MechanismScene& scene, const Simulation& simulation, int digits);

/// One JSON document, schema slipproof/simulate/1. What is exact in it is a string, what is simulated a number.
std::string simulation_json(const MechanismScene& scene, const Simulation& simulation);

}  // namespace slipproof
