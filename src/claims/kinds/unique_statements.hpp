// What a claim of uniqueness says, as statements.
#pragma once

#include "claims/statements/claim_writer.hpp"

namespace slipproof {

/// Where a claim states a motion there is no other; and beyond the claims there is one of the modes listed, and no
/// other, and no two of these at once. What is beyond all claims is shown cell by cell, between the boundaries in their
/// regions, and that the cells are all there is.
/// - ID.CLAIM for each claim of `claims`, ID.CLAIM.one: no two motions in its mode, ID.CLAIM.exists: there is one;
/// - ID.rest.1, .2, ... and ID.rest.exists.1, .2, ... for the cells; ID.rest.cells;
/// - ID.rest.one.I-K for the modes of `modes`, two at a time and each with itself: what is in both is one motion.
/// All count boundary motions, whatever the setting says.
/// Writes nothing where a claim's forces could have infinitely many ends.
void unique_statements(ClaimWriter& writer);

/// A strict motion, which is in one mode only, where a claim states another mode; or where no claim is near, and its
/// mode is not listed. Gives up where no mode is wrong anywhere.
void unique_refutation(ClaimWriter& writer);

}  // namespace slipproof
