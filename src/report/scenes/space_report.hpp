// The report on a scene in space: all motions, as text and as `slipproof/space/1`.
#pragma once

#include <string>

#include "base/output/json.hpp"
#include "contact/space/solved_space.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// For people; `digits` is the number of significant digits of decimals.
Document space_document(const SolvedSpace& solved, int digits);
/// A motion as in the document slipproof/space/1.
Json motion_json(const Mechanism& mechanism, const SpaceMotion& motion);
/// The document slipproof/space/1.
std::string space_json(const SolvedSpace& solved);

}  // namespace slipproof
