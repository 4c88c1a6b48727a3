// Impacts: all velocities after an impact, as a mechanism that everything else knows how to solve.
//
// With impulses P and velocities u before and after, M (u_after - u_before) = J^T P. Finite forces have no impulse in
// no time, and J does not change: so this is the same problem, with velocities in place of accelerations and impulses
// in place of forces. What a law adds is a constant of each gap: 0 <= P_N, complementary to u_N after + e u_N before.
// Coulomb's law is by the velocity of sliding after the impact.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/bodies/derive.hpp"

namespace slipproof {

/// Of each contact: -1, 0 or +1 as it approaches, rests or opens before; nothing where that depends on parameters.
using Approaches = std::vector<std::optional<int>>;

/// The mechanism of the impact in a mechanism by bodies, from what derive_mechanism() found. Unknown accelerations
/// become velocities after: `ax` is `vx`, `alpha` is `omega`, with `_after` behind it where the file has such a name;
/// names that the file gives stay. A gap is what the law has complementary to N; slip is the velocity of sliding after.
/// Limits of friction are the kinetic ones. The load has no impulse and becomes a parameter that may be left out.
/// Moreau's law restores velocity at all closed contacts, Newton's at those that approach; both restore sliding by a
/// restitution of its own. Poisson's law in space restores nothing in this mechanism, which is one phase: its outcomes
/// are those of both, with the restitution of each contact of its bodies. Reports a contact without a restitution, and
/// what the law cannot have.
Mechanism impact_of(const Mechanism& mechanism, const Bodies& bodies, const BodyGeometry& geometry,
                    const Approaches& approaches, ImpactLaw law, Mistakes& mistakes);

/// The mechanism of an impact, with a domain that holds only points at which some contact approaches. Throws InputError
/// if no contact is closed.
Mechanism with_approach(Mechanism mechanism);

}  // namespace slipproof
