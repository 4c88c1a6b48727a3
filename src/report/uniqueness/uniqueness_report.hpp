// The output of `slipproof critical`: for which values of a parameter each load has one motion.
#pragma once

#include <string>

#include "claims/uniqueness/along.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// For people; `digits` is the number of significant digits of decimals. The status begins with `s UNIQUE`, `s
/// SEVERAL`, `s CONTINUUM` or `s NONE`: the worst result over the loads of the scene itself, in this order.
Document uniqueness_document(const MechanismScene& scene, const UniquenessAlong& along, int digits);

/// One JSON document, schema slipproof/critical/1, with every value at which something may change.
std::string uniqueness_json(const MechanismScene& scene, const UniquenessAlong& along);

}  // namespace slipproof
