// What a claim of uniqueness says, as statements.
#pragma once

#include "statements/claim_writer.hpp"

namespace slipproof {

/// Where a claim states a motion there is no other; and beyond the claims there is one of the modes listed, and no
/// other, and no two of these at once. What is beyond all claims is shown cell by cell, between the boundaries in their
/// regions, and that the cells are all there is.
/// - ID.CLAIM for each claim of `claims`;
/// - ID.rest.1, .2, ... and ID.rest.exists.1, .2, ... for the cells; ID.rest.cells;
/// - ID.rest.one.I-K for the modes of `modes`, two at a time.
/// Writes nothing where a claim's forces could have infinitely many ends. The statements ID.always of the claims belong
/// to the proof, too: that the motions exist of which there are no others.
void unique_statements(ClaimWriter& writer);

}  // namespace slipproof
