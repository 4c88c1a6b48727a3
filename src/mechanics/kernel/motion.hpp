// Modes and motions as results: data, without what finds them.
//
// A motion is its accelerations. Modes, or solutions of one mode, that differ only in their forces are one motion with
// undetermined forces, as for a body on two contacts at rest. A mode is a continuum only if its accelerations vary.
#pragma once

#include <optional>
#include <vector>

#include "base/number/affine.hpp"
#include "mechanics/elements/state_rows.hpp"
#include "mechanics/kernel/polyhedron.hpp"

namespace slipproof {

/// A condition of a mode that is violated.
struct ViolatedCondition {
  std::size_t element;
  ElementState state;
  StateCondition condition;
  bool operator==(const ViolatedCondition&) const = default;
};

/// A mode with solutions.
struct ConsistentMode {
  MechanismMode mode;
  Polyhedron solutions;
  bool determined = false;  ///< all solutions for one load are one motion: no acceleration varies
};

/// A mode without a solution. No conditions: its equations have none. Where modes that begin alike were rejected
/// together the reason is that of their beginning; mode_of gives the mode's own: one condition if one suffices.
struct RejectedMode {
  MechanismMode mode;
  std::vector<ViolatedCondition> because;  ///< conditions that exclude each other
  std::optional<Rational> margin;          ///< value of a single condition that is violated equally for all forces
};

struct ModesOf {
  std::vector<ConsistentMode> consistent;
  std::vector<RejectedMode> rejected;
};

struct MotionAtLoad {
  std::vector<MechanismMode> modes;           ///< modes in which it is strict
  std::vector<MechanismMode> boundary_modes;  ///< the others
  std::vector<Rational> accelerations;        ///< in the order of FrictionProblem::accelerations
  std::vector<Range> forces;                  ///< in the order of FrictionProblem::forces, over all of its modes
  std::vector<MechanismMode> continua;        ///< modes of the continua that contain it

  bool strict() const { return !modes.empty(); }
  /// Those of both lists.
  std::vector<MechanismMode> all_modes() const;
};

struct ContinuumAtLoad {
  MechanismMode mode;
  bool strict = false;
  std::vector<Range> accelerations, forces;
};

struct MotionsAtLoad {
  std::vector<MotionAtLoad> motions;  ///< motions of all modes with one motion, isolated or in a continuum
  std::vector<ContinuumAtLoad> continua;
  std::vector<RejectedMode> rejected;
  /// The modes were not all tried: some boundary modes of each motion are missing, and all that are rejected.
  bool by_kinematics = false;
  /// Several motions that are one where each static limit is the kinetic one: the modes that there are no more then.
  std::vector<MechanismMode> hysteresis;
};

/// All modes of the motions that a continuum contains.
std::vector<MechanismMode> modes_in(const MotionsAtLoad& found, const ContinuumAtLoad& continuum);

/// A motion over a set of loads; without numbers if only modes were requested.
struct MotionOverLoads {
  std::vector<MechanismMode> modes, boundary_modes;
  std::vector<Affine<Rational>> accelerations;          ///< as functions of the load
  std::vector<std::optional<Affine<Rational>>> forces;  ///< nothing where one is undetermined
  std::vector<MechanismMode> continua;                  ///< modes of the continua that contain it

  /// Those of both lists.
  std::vector<MechanismMode> all_modes() const;
};

/// Loads with the same motions: a point, or an open interval.
struct LoadCell {
  ForceInterval loads;
  std::vector<MotionOverLoads> motions;
  std::vector<MechanismMode> continua;
};

/// What is found at one load, or in a problem without one, as a cell of all loads; without the numbers.
LoadCell cell_of(const MotionsAtLoad& found);

}  // namespace slipproof
