// The contact problem of a scene, for other programs and for `certify`.
#pragma once

#include "contact/problem/global_problem.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// The contact problem of a scene at its load. Uses the local form, with the equations solved for the contact forces,
/// if some forces belong to no contact or if equations are given as printed; otherwise the global form. v are the
/// accelerations, u the gap and slip accelerations, r the contact forces, lambda the forces of links and of guides
/// without friction. Open contacts are left out. In space as of space_problem.hpp. Throws InputError for scenes that such a problem cannot express: a
/// friction element, a guide with friction, a contact that slides, a static coefficient of its own, rows that are not
/// those of virtual work, a load without a value.
GlobalProblem global_problem(const MechanismScene& scene);

}  // namespace slipproof
