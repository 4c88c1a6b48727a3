// Every motion of a problem: at one load, and for all loads.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mechanics/kernel/mode_solver.hpp"

namespace slipproof {

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

/// The result for more than max_tried modes (kinematic_modes.hpp).
enum class Listing : std::uint8_t {
  motions,  ///< every motion, by kinematics, with some of its modes
  modes     ///< every mode, if every_mode() has them; if not, as before
};

/// All motions at a load, which may lie outside the domain; a problem without a load takes none. Throws TooMuchWork
/// beyond kinematic_effort.
MotionsAtLoad motions_of(const FrictionProblem& problem, const std::optional<Rational>& load,
                         Listing listing = Listing::motions);

/// The same by kinematics (kinematic_modes.hpp), for any number of modes. Throws TooMuchWork beyond the effort.
MotionsAtLoad motions_by_kinematics(const FrictionProblem& problem, const std::optional<Rational>& load,
                                    Effort& effort);

/// The problem with its static limits lowered to the kinetic ones; nothing if they are equal. If several motions become
/// one in it, they are due to hysteresis.
std::optional<FrictionProblem> without_hysteresis(const FrictionProblem& problem);

/// How much to report about motions: modes only, for counting, or modes and numbers.
enum class Detail : std::uint8_t { modes, numbers };

/// Divides the domain of the load into points and open intervals, ascending; in each the motions have the same modes.
/// `consistent` are the problem's modes for all loads; neighbours may be alike.
std::vector<LoadCell> cells_of(const FrictionProblem& problem, const std::vector<ConsistentMode>& consistent,
                               Detail detail = Detail::numbers);

}  // namespace slipproof
