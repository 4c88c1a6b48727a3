// The modes of mechanisms with many contacts, without trying all of them.
//
// n contacts have 4^n modes, but a body that moves in the plane has few ways to move at them: each acceleration opens a
// gap or leaves it closed, and slides forward, backward or not, and the signs that go together are the faces of an
// arrangement of hyperplanes, of which there are polynomially many in n for a fixed number of bodies. Each motion
// belongs to one of them. So elements take their states one after the other, where a gap that opens is positive, a
// sliding not zero, and a contact that does neither sticks; a branch ends where no accelerations and forces are left
// that the laws of all contacts allow, which a linear program decides: in it the elements to come have what all of
// their states have, N >= 0, gap >= 0 and |S| <= mu N.
//
// Each motion is found, in a mode whose signs are those of its accelerations. Other modes that it has at their borders,
// as a foot that lifts with gap 0, are not: there can be 4^n of them. every_mode() finds these, too, as long as they
// can all be tried.
#pragma once

#include <optional>
#include <vector>

#include "base/number/effort.hpp"
#include "mechanics/kernel/mode_solver.hpp"

namespace slipproof {

/// At a load, or for all loads of the domain. Takes a linear program in all forces for each branch; throws TooMuchWork
/// beyond the effort.
std::vector<ConsistentMode> kinematic_modes(const FrictionProblem& problem, const std::optional<Rational>& load,
                                            Effort& effort);

/// Of more modes not all are tried where only the motions matter.
inline constexpr double max_tried = 1024;
bool has_too_many_to_try(const FrictionProblem& problem);

/// Some seconds.
inline constexpr Work kinematic_effort = 20'000'000'000;

/// As many modes are tried where each is asked for. A table on six feet has 4^6, most of them at rest; its cells over
/// the loads take four seconds, and time grows with the square. At one load the 4^8 modes of eight feet take ten.
inline constexpr double max_listed = static_cast<double>(max_modes), max_listed_over_loads = 4096;

/// All modes at a load, or for all loads of the domain; nothing if that takes more than kinematic_effort, or if there
/// are more than max_tried and more than max_listed or max_listed_over_loads.
std::optional<ModesOf> every_mode(const FrictionProblem& problem, const std::optional<Rational>& load);

/// All consistent modes, or where there are too many to try those by kinematics; throws TooMuchWork beyond
/// kinematic_effort.
std::vector<ConsistentMode> consistent_modes(const FrictionProblem& problem, const std::optional<Rational>& load);

}  // namespace slipproof
