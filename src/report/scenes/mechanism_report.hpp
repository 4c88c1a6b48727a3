// What is told of a mechanism's scene: all motions, as text and as `slipproof/solve/2`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/problem/every_load.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// A scene of a mechanism with everything that is known of its motions.
struct SolvedMechanism {
  /// Throws InputError where the mechanism has more modes than are tried, or a coefficient has no value.
  explicit SolvedMechanism(MechanismScene given);

  MechanismScene scene;
  FrictionProblem problem;               ///< its equations solved
  std::vector<ConsistentMode> modes;     ///< for all loads; of a mechanism without a load empty
  std::optional<MotionsAtLoad> at_load;  ///< where the load has a value, or there is none
  std::vector<LoadCell> cells;           ///< where the load has no value
  std::optional<EveryLoad> for_every_q;  ///< nothing where the contacts are none that the theorem is about
};

/// The beginning of what is said of a scene: what it is about, its notes, and what of it is not modelled.
Document scene_document(const MechanismScene& scene, const std::string& about);

/// What a mode without a motion breaks: `N1 >= 0`, `gap1 >= 0 against N2 >= 0`, or that its equations have no solution.
std::string what_is_broken(const Mechanism& mechanism, const RejectedMode& mode);

/// For people; `digits` is how many significant ones a decimal has.
Document solve_document(const SolvedMechanism& solved, int digits);
/// The document slipproof/solve/2.
std::string solve_json(const SolvedMechanism& solved);

}  // namespace slipproof
