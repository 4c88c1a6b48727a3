// The motions of a mechanism at one load, as `slipproof/solve/2` has them.
#pragma once

#include "mechanism/mechanism.hpp"
#include "motions/motions_of.hpp"
#include "wording/exact_json.hpp"

namespace slipproof {

/// Puts `motions`, `hysteresis`, `continua` and `rejected` into a document.
void put_motions(Json& document, const Mechanism& mechanism, const MotionsAtLoad& found);

}  // namespace slipproof
