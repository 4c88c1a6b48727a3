// The report on a mechanism's scene: all motions, as text and as `slipproof/solve/2`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/problem/every_load.hpp"
#include "mechanics/scene/solved_mechanism.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// What the report says first of a scene: the title, its notes, and the parts of it that are not modelled.
Document scene_document(const MechanismScene& scene, const std::string& about);

/// What a mode without a motion breaks: `N1 >= 0`, `gap1 >= 0 against N2 >= 0`, or that its equations have no solution.
std::string what_is_broken(const Mechanism& mechanism, const RejectedMode& mode);

/// For people; `digits` is the number of significant digits of decimals. `every_q` is what for_every_push() finds.
Document solve_document(const SolvedMechanism& solved, const std::optional<EveryLoad>& every_q, int digits);
/// The document slipproof/solve/2.
std::string solve_json(const SolvedMechanism& solved, const std::optional<EveryLoad>& every_q);

}  // namespace slipproof
