// The motions of one mechanism for every load, in the form that claims and phase diagrams need, independent of the
// algorithm that finds them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "mechanics/kernel/motions.hpp"

namespace slipproof {

/// A mode over the loads. The intervals belong to what gave it out.
struct ModeOverLoads {
  const ForceInterval* closed = nullptr;  ///< the loads at which it has solutions
  const ForceInterval* strict = nullptr;  ///< those at which one meets all of its conditions strictly
  bool continuum = false;                 ///< its accelerations vary at one load
};

/// The solutions of a mode's equations, as forms over the parameters that are left free, perhaps none, and the load.
struct ModeForms {
  std::size_t free = 0;
  std::vector<AffineForm> accelerations, forces;  ///< in the order of FrictionProblem
  std::vector<AffineForm> conditions;             ///< forms that must be >= 0
  bool with_cones = false;  ///< friction in a cone is a condition, too, on forces that are not determined
};

/// All modes at one point of a mechanism. References that it returns are valid while it lives. May be used by several
/// threads.
class MotionsOverLoads {
 public:
  virtual ~MotionsOverLoads() = default;

  /// The mode over its loads; nothing if it is not modelled.
  virtual std::optional<ModeOverLoads> find(const MechanismMode& mode) const = 0;
  /// Null if its equations have no solution at any load. Computed at the first call for a mode.
  virtual const ModeForms* forms(const MechanismMode& mode) const = 0;
  /// The domain of the load as points and open intervals, ascending; in each the motions have the same modes. If not
  /// all modes are tried (kinematic_modes.hpp), each motion has the modes that kinematics finds, and those that are
  /// `named`.
  virtual std::vector<LoadCell> cells(Detail detail = Detail::numbers,
                                      const std::vector<MechanismMode>& named = {}) const = 0;
  /// Whether all modes are tried, so that no mode need be named.
  virtual bool all_tried() const = 0;
};

/// Uses the kernel. A mode of a mechanism in space (which has no load) in which forces are not determined counts as not
/// modelled where polygons of 128 sides in and around the circles of friction do not decide whether it has a motion.
/// Without `only`, solves all modes, at most max_modes. With `only`, solves these modes and no others;
/// then cells() must not be called.
std::unique_ptr<const MotionsOverLoads> motions_over_loads(FrictionProblem problem,
                                                           const std::optional<std::vector<MechanismMode>>& only = {});

}  // namespace slipproof
