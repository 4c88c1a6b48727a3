// Finds all outcomes of an impact.
#pragma once

#include "contact/impact/solved_impact.hpp"

namespace slipproof {

/// Of a scene that was read with a law, or whose mechanism has one. Throws InputError where no contact approaches, for
/// a load without a value, and as solve_mechanism() and solve_space() do.
SolvedImpact solve_impact(MechanismScene scene);

}  // namespace slipproof
