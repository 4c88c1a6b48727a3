// Records of bicycles in the symbols of the paper: short forms for records of the shipped mechanism `bicycle`.
#pragma once

#include "records/record/record.hpp"

namespace slipproof {

/// h0 for h; b for b2 and b3; mu for r1, r2; M2 and M3 for M, I1, I2, I3, r1, r2; P for F; a column `kind` with
/// `internal` (the default) or `external`. An answer must have a, S2, S3, N2, N3, and may have a_y, phi, eps2, eps3.
CertifiedMechanism bicycle_records();
/// The values of the scene are the same for all records, unless a record gives its own.
CertifiedMechanism bicycle_records(MechanismScene scene);

/// The records of a scene, given as the text of its file: of a mechanism, or of a bicycle in these symbols.
CertifiedMechanism records_of_scene(const std::string& text, const std::string& file);

}  // namespace slipproof
