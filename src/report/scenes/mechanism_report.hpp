// The report on a mechanism's scene: all motions, as text and as `slipproof/solve/2`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/problem/every_load.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// A scene of a mechanism with all results about its motions.
struct SolvedMechanism {
  /// Finds every mode, or, where there are too many to try or only motions are asked for, every motion by kinematics
  /// (kinematic_modes.hpp). Throws InputError if that takes more than some seconds, or if a coefficient has no value.
  /// Without `with_every_q`, for_every_q stays empty: it may take most of the time.
  explicit SolvedMechanism(MechanismScene given, bool with_every_q = true, Listing listing = Listing::modes);

  MechanismScene scene;
  FrictionProblem problem;               ///< with its equations solved
  bool by_kinematics = false;            ///< boundary modes of the motions found are missing, and rejected modes
  bool ranges_complete = true;           ///< whether `modes` and `cells` have all modes
  std::vector<ConsistentMode> modes;     ///< for all loads; empty for a mechanism without a load
  std::optional<MotionsAtLoad> at_load;  ///< if the load has a value, or the mechanism has no load
  std::vector<LoadCell> cells;           ///< if the load has no value
  std::optional<EveryLoad> for_every_q;  ///< nothing if the theorem does not apply to the contacts

 private:
  void find_motions(Listing listing);
  void find_modes(Listing listing);
};

/// What the report says first of a scene: the title, its notes, and the parts of it that are not modelled.
Document scene_document(const MechanismScene& scene, const std::string& about);

/// What a mode without a motion breaks: `N1 >= 0`, `gap1 >= 0 against N2 >= 0`, or that its equations have no solution.
std::string what_is_broken(const Mechanism& mechanism, const RejectedMode& mode);

/// For people; `digits` is the number of significant digits of decimals.
Document solve_document(const SolvedMechanism& solved, int digits);
/// The document slipproof/solve/2.
std::string solve_json(const SolvedMechanism& solved);

}  // namespace slipproof
