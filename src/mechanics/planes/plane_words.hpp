// How phase diagrams describe a motion: its quantities by name, and its modes in words.
#pragma once

#include "mechanics/mechanism/mechanism.hpp"
#include "mechanics/planes/phase_diagram.hpp"

namespace slipproof {

/// Uses the names in the mechanism's file, and words such as "left sticks, right is open".
void tell_of_mechanism(Plane& plane, const Mechanism& mechanism);

}  // namespace slipproof
