// The report of critical in space: how many motions there are along a parameter, and where that changes.
#pragma once

#include <string>

#include "mechanics/planes/sets_along.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/document/document.hpp"

namespace slipproof {

Document sets_document(const MechanismScene& scene, const SetsAlong& along, int digits);
/// Schema slipproof/critical-space/1.
std::string sets_json(const MechanismScene& scene, const SetsAlong& along);

}  // namespace slipproof
