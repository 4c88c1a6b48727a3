// What phase diagrams of bicycles have in common.
#pragma once

#include "picture/phase_diagram.hpp"

namespace slipproof {

/// Lets a plane whose columns are cells of bicycle_motions() tell the quantities of a motion by the names of the model,
/// and a mode in words: "both wheels roll".
void tell_of_bicycles(Plane& plane);

}  // namespace slipproof
