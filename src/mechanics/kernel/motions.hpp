// Every motion of a problem: at one load, and for all loads.
//
// A motion is its accelerations. Modes, or solutions of one mode, that differ only in their forces are one motion with
// undetermined forces, as for a body on two contacts at rest. A mode is a continuum only if its accelerations vary.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/number/affine.hpp"
#include "mechanics/kernel/mode_solver.hpp"

namespace slipproof {

struct MotionAtLoad {
  std::vector<MechanismMode> modes;           ///< in which it is strict
  std::vector<MechanismMode> boundary_modes;  ///< the others
  std::vector<Rational> accelerations;        ///< in the order of FrictionProblem::accelerations
  std::vector<Range> forces;                  ///< of FrictionProblem::forces, over all of its modes
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
  std::vector<MotionAtLoad> motions;  ///< of all modes with one motion, alone or in a continuum
  std::vector<ContinuumAtLoad> continua;
  std::vector<RejectedMode> rejected;
  /// The modes were not all tried: some boundary modes of each motion are missing, and all that are rejected.
  bool by_kinematics = false;
  /// Several motions that are one where each static limit is the kinetic one: the modes that there are no more then.
  std::vector<MechanismMode> hysteresis;
};

/// All modes of the motions that a continuum contains.
std::vector<MechanismMode> modes_in(const MotionsAtLoad& found, const ContinuumAtLoad& continuum);

/// The modes at one load, merged: motions, each with the indices of its modes and of the continua that contain it, and
/// continua.
struct MergedModes {
  struct Motion {
    std::vector<Rational> accelerations;
    std::vector<std::size_t> modes, within;
  };
  std::vector<Motion> motions;
  std::vector<std::size_t> continua;
};
/// Throws TooMuchWork beyond an effort.
MergedModes merge(const FrictionProblem& problem, const std::vector<ConsistentMode>& consistent,
                  Effort* effort = nullptr);

/// What is found of more than max_tried modes (kinematic_modes.hpp).
enum class Listing : std::uint8_t {
  motions,  ///< every motion, by kinematics, with some of its modes
  modes     ///< every mode, if every_mode() has them; if not, as before
};

/// All motions at a load, which need not be of the domain; a problem without a load takes none. Throws TooMuchWork
/// beyond kinematic_effort.
MotionsAtLoad motions_of(const FrictionProblem& problem, const std::optional<Rational>& load,
                         Listing listing = Listing::motions);

/// The same by kinematics (kinematic_modes.hpp), for any number of modes. Throws TooMuchWork beyond the effort.
MotionsAtLoad motions_by_kinematics(const FrictionProblem& problem, const std::optional<Rational>& load,
                                    Effort& effort);

/// The same problem with static limits as low as the kinetic ones; nothing where they are. Several motions that are one
/// then are hysteresis.
std::optional<FrictionProblem> without_hysteresis(const FrictionProblem& problem);

/// A motion over a set of loads; without the numbers where they were not asked for.
struct MotionOverLoads {
  std::vector<MechanismMode> modes, boundary_modes;
  std::vector<Affine<Rational>> accelerations;          ///< of the load
  std::vector<std::optional<Affine<Rational>>> forces;  ///< nothing where one is undetermined
  std::vector<MechanismMode> continua;                  ///< modes of the continua that contain it
};

/// Loads with the same motions: a point, or an open interval.
struct LoadCell {
  ForceInterval loads;
  std::vector<MotionOverLoads> motions;
  std::vector<MechanismMode> continua;
};

/// How much to report about motions: modes only, for counting, or modes and numbers.
enum class Detail : std::uint8_t { modes, numbers };

/// Divides the domain of the load, from below, into points and open intervals, in each of which the motions have the
/// same modes. `consistent` are the problem's modes for all loads; neighbours may be alike.
std::vector<LoadCell> cells_of(const FrictionProblem& problem, const std::vector<ConsistentMode>& consistent,
                               Detail detail = Detail::numbers);

}  // namespace slipproof
