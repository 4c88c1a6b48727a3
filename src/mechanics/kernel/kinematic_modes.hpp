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
// as a foot that lifts with gap 0, are not: there can be 2^n of them.
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

/// Of more modes not all are tried: trying 4^6, of which a body at rest has most at its borders, takes seconds.
inline constexpr double max_tried = 1024;
bool has_too_many_to_try(const FrictionProblem& problem);

/// Some seconds.
inline constexpr Work kinematic_effort = 20'000'000'000;

/// All consistent modes, or where there are too many to try those by kinematics; throws TooMuchWork beyond
/// kinematic_effort.
std::vector<ConsistentMode> consistent_modes(const FrictionProblem& problem, const std::optional<Rational>& load);

}  // namespace slipproof
