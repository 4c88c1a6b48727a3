// The modes of mechanisms with many contacts, without trying all of them.
//
// n contacts have 4^n modes, but planar bodies can move in few ways: an acceleration opens each gap or keeps it closed,
// and slides forward, backward or not at all. The possible combinations of signs are the faces of an arrangement of
// hyperplanes; for a fixed number of bodies their number is polynomial in n, and each motion belongs to one face. The
// search assigns states to the elements one after the other: in an opening state the gap acceleration is positive, in a
// sliding state the slip acceleration is not 0, and otherwise the contact sticks. A linear program cuts a branch if no
// accelerations and forces satisfy the laws of all contacts; in it, elements without a state yet have only the
// conditions common to all their states: N >= 0, gap >= 0 and |S| <= mu N.
//
// Each motion is found in the mode whose signs are those of its accelerations. Its other modes, on whose boundary it
// lies, such as a foot that lifts with gap acceleration 0, are not found: there can be 4^n of them. every_mode() finds
// these, too, if there are few enough to try them all.
#pragma once

#include <optional>
#include <vector>

#include "base/number/effort.hpp"
#include "mechanics/kernel/mode_solver.hpp"

namespace slipproof {

/// Finds the modes at a load, or for all loads of the domain. Solves one linear program in all forces for each branch;
/// throws TooMuchWork beyond the effort.
std::vector<ConsistentMode> kinematic_modes(const FrictionProblem& problem, const std::optional<Rational>& load,
                                            Effort& effort);

/// Above this number of modes, not all are tried if only the motions matter.
inline constexpr double max_tried = 1024;
bool has_too_many_to_try(const FrictionProblem& problem);

/// A limit of some seconds.
inline constexpr Work kinematic_effort = 20'000'000'000;

/// Up to this number of modes, all are tried if the modes themselves are wanted. A table on six feet has 4^6, most of
/// them at rest; its cells over the loads take four seconds, and the time grows with the square. At one load the 4^8
/// modes of eight feet take ten seconds.
inline constexpr double max_listed = static_cast<double>(max_modes), max_listed_over_loads = 4096;

/// All modes at a load, or for all loads of the domain; nothing if that takes more than kinematic_effort, or if there
/// are more than max_tried and more than max_listed or max_listed_over_loads.
std::optional<ModesOf> every_mode(const FrictionProblem& problem, const std::optional<Rational>& load);

/// All consistent modes; if there are too many to try, those that kinematics finds. Throws TooMuchWork beyond
/// kinematic_effort.
std::vector<ConsistentMode> consistent_modes(const FrictionProblem& problem, const std::optional<Rational>& load);

}  // namespace slipproof
