// The motions of a mechanism at one load, in the form of `slipproof/solve/2`.
#pragma once

#include "mechanics/kernel/motion.hpp"
#include "mechanics/mechanism/mechanism.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

/// Loads and the modes of their motions: `load`, `closed`, `motions`, `continua`.
Json cell_json(const LoadCell& cell);
/// The same with the motions' accelerations and forces as functions of the load; an undetermined force is null.
Json cell_json(const LoadCell& cell, const Mechanism& mechanism);
/// [lower, upper]; null for an end that is not there.
Json ends_json(const Range& range);
/// A number as a function of the load.
Json over_load_json(const Affine<Rational>& value);

/// Puts `motions`, `hysteresis`, `continua` and `rejected` into a document.
void put_motions(Json& document, const Mechanism& mechanism, const MotionsAtLoad& found);

}  // namespace slipproof
