// Where the motions of a scene become others along one of its parameters, or along its load.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/algebra/real_roots.hpp"
#include "mechanics/elements/element.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// Which motions there are at one value.
struct MotionsThere {
  std::vector<std::vector<MechanismMode>> motions;  ///< by their modes, strict ones first; sorted
  std::vector<MechanismMode> continua;
};

struct MotionChange {
  RealRoot at;
  MotionsThere below, above;         ///< directly beside it
  std::optional<MotionsThere> here;  ///< nothing at an irrational value, where no scene is, or outside the domain
};

/// Mechanisms with more modes are not followed along a parameter.
inline constexpr std::size_t max_change_modes = 256;

/// The values strictly between `from` and `to` at which there are other motions than directly below or above,
/// ascending. A motion stays the same as long as one of its modes does: which other modes share it, where forces are
/// not determined, is no change. Everything else is as in the scene: its load keeps its value, which it must have.
/// Exact (mechanics/lines/critical.hpp), but where a mode leaves so many forces open that they are not eliminated, its
/// changes may be missed. Throws std::invalid_argument, with a message for people: no such parameter, no value of the
/// load, too many modes, an interval that is not in the domain.
std::vector<MotionChange> motion_changes(const MechanismScene& scene, const std::string& parameter,
                                         const Rational& from, const Rational& to);

}  // namespace slipproof
