// Writes a claim of uniqueness as statements.
#pragma once

#include "claims/statements/claim_writer.hpp"

namespace slipproof {

/// Where a claim states a motion, there is no other motion. Away from all claims there is a motion in one of the listed
/// modes, no motion in another mode, and never two different ones. This second part is shown cell by cell, between the
/// boundaries in the claims' regions, together with the statement that the cells cover everything.
/// - ID.CLAIM for each claim of `claims`; ID.CLAIM.one: no two motions in its mode; ID.CLAIM.exists: there is one;
/// - ID.rest.1, .2, ... and ID.rest.exists.1, .2, ... for the cells; ID.rest.cells;
/// - ID.rest.one.I-K for the modes of `modes`, each pair and each with itself: motions in both are the same motion.
/// All statements count boundary motions, whatever the setting says. Writes nothing if a claim's forces could have
/// infinitely many ends.
void unique_statements(ClaimWriter& writer);

/// Writes that there is a strict motion, which is in one mode only, where a claim states another mode; or where no
/// claim is near and the mode is not listed. Gives up if no mode is wrong anywhere.
void unique_refutation(ClaimWriter& writer);

}  // namespace slipproof
