// What phase diagrams tell of a motion: its quantities by name, and its modes in words.
#pragma once

#include "mechanics/mechanism/mechanism.hpp"
#include "report/phase/phase_diagram.hpp"

namespace slipproof {

/// The names of its file, and "left sticks, right is open".
void tell_of_mechanism(Plane& plane, const Mechanism& mechanism);

}  // namespace slipproof
