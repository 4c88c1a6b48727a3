// Whether bodies whose contacts are redundant have one motion whatever else pushes them.
//
// A body on two level feet has more contact forces than directions in which it can move: W is singular, and the theorem
// of every_load.hpp says nothing. A push q = G f accelerates what the bodies allow, and so do contact forces: with W
// symmetric and positive semidefinite both, and so w, are in the range of W where the problem's own q is. Two solutions
// (w, z), (w', z') under one such q have w - w' = W (z - z'), and each pair of modes makes that a cone: linear
// equations and inequalities without constants. If w = w' on all of these cones, no push whatever allows two motions.
// If not, a point of a cone has w != w', and q = w - W z is a push under which both are motions. So linear programs
// decide, without a theorem about determinants. What z is left open is the kernel of W.
//
// This says that there are never two motions; that there is one is not said.
#pragma once

#include "contact/problem/every_load.hpp"

namespace slipproof {

/// A fraction of a second.
inline constexpr Work push_effort = 40'000'000;

/// What for_every_load() finds where W is positive definite or not symmetric and positive semidefinite, or q is not in
/// its range. Otherwise `at_most_one` or `not_unique`, by pairs of modes, with the dimension of the kernel of W. Takes
/// some linear programs in as many variables as W has rows for each pair of modes; `undecided` beyond the effort.
EveryLoad for_every_push(const ContactProblem& problem, Work effort = push_effort);

/// The same for a mechanism's contacts, whose equations are solved (without_equations()). Nothing if they are no
/// contact_problem(), or have more modes than are all tried. May take most of the time of a scene.
std::optional<EveryLoad> for_every_push(const FrictionProblem& problem);

}  // namespace slipproof
