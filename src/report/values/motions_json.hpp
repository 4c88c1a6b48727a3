// The motions of a mechanism at one load, as `slipproof/solve/2` has them.
#pragma once

#include "mechanics/kernel/motions.hpp"
#include "mechanics/mechanism/mechanism.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

/// Loads with the modes of their motions: `load`, `closed`, `motions`, `continua`.
Json cell_json(const LoadCell& cell);
/// The same with the motions' accelerations and forces over the load; a force that is undetermined is null.
Json cell_json(const LoadCell& cell, const Mechanism& mechanism);
/// A number over the load.
Json over_load_json(const Affine<Rational>& value);

/// Puts `motions`, `hysteresis`, `continua` and `rejected` into a document.
void put_motions(Json& document, const Mechanism& mechanism, const MotionsAtLoad& found);

}  // namespace slipproof
