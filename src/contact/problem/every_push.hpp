// Decides whether bodies with redundant contacts have at most one motion under every load.
//
// A body on two level feet has more contact forces than directions in which it can move: W is singular, and the theorem
// of every_load.hpp does not apply. If W is symmetric and positive semidefinite, and the problem's own q is in its
// range, then so are W z and the q = G f of every push on the bodies, and therefore w. Two solutions (w, z), (w', z')
// under one such q have w - w' = W (z - z'), and each pair of modes makes that a cone: linear equations and
// inequalities without constants. If w = w' on all of these cones, no push allows two motions. Otherwise a point of a
// cone has w != w', and q = w - W z is a push under which both are motions. So linear programs decide, without a
// theorem about determinants. z is undetermined by the kernel of W.
//
// The result excludes two motions; it does not state that there is one.
#pragma once

#include "contact/problem/every_load.hpp"

namespace slipproof {

/// A fraction of a second.
inline constexpr Work push_effort = 40'000'000;

/// Calls for_every_load() if W is positive definite, if it is not symmetric and positive semidefinite, or if q is not
/// in its range. Otherwise gives `at_most_one` or `not_unique`, by pairs of modes, with the dimension of the kernel of
/// W. Takes some linear programs for each pair of modes, in as many variables as W has rows; `undecided` beyond the
/// effort.
EveryLoad for_every_push(const ContactProblem& problem, Work effort = push_effort);

/// The same for the contacts of a mechanism, whose equations must be solved (without_equations()). Nothing if they are
/// not a contact_problem(), or have more modes than can be tried. May take most of the time of a scene.
std::optional<EveryLoad> for_every_push(const FrictionProblem& problem);

}  // namespace slipproof
