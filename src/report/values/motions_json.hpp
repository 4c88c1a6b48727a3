// The motions of a mechanism at one load, as `slipproof/solve/2` has them.
#pragma once

#include "mechanics/kernel/motions.hpp"
#include "mechanics/mechanism/mechanism.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

/// Puts `motions`, `hysteresis`, `continua` and `rejected` into a document.
void put_motions(Json& document, const Mechanism& mechanism, const MotionsAtLoad& found);

}  // namespace slipproof
