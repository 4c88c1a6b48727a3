// The contact problem of a scene, for other programs and for `certify`.
#pragma once

#include "contact/exchange/global_problem.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// At the scene's load. Where forces belong to no contact, or equations are given as printed, the local form, in which
/// the equations are solved for the contacts' forces; else the global one. v are the accelerations, u the gaps and
/// slips, r and lambda the forces of contacts and of what holds always: links, and guides without friction. Contacts
/// that are open have no part in it. Throws InputError for what no such problem says: a friction element, a guide with
/// friction, a contact that slides, a static coefficient of its own, rows that are not those of virtual work, a load
/// without a value.
GlobalProblem global_problem(const MechanismScene& scene);

}  // namespace slipproof
