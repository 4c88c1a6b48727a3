// Poisson's law: an impact in two problems, as one mechanism.
#pragma once

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// In compression a closed contact does not open into itself: 0 <= P_c, complementary to u_c. Restitution begins with
/// u_c, and gives back e P_c at least: 0 <= P_r - e P_c, complementary to u after, with friction |P_T| <= mu P_r. So
/// one mechanism has the unknowns of both, and each outcome of compression goes on with each of restitution.
///
/// `after` and `compression` are the impact without restitution, with two sets of names for its velocities and
/// quantities; `restitution` is e of each contact. Contacts of `after` come first, without friction, and with N the
/// impulse beyond e P_c; then those of compression; then friction elements with the limits of restitution. Forces that
/// are no element's come first, by the names of the file: the impulses of both together. In the plane.
Mechanism poisson_of(const Mechanism& after, const Mechanism& compression, const std::vector<Expression>& restitution,
                     Mistakes& mistakes);

}  // namespace slipproof
