// Certificates for Coq: another checker of the same proofs.
#pragma once

#include <string>

namespace slipproof {

/// A file for `coqc` that proves the statement (the content of `file`) over the reals of Coq's standard library by the
/// steps of the certificate. The theorem comes from the statement alone: its lines, a comparison that divides being
/// guarded by `divisor <> 0`. The proof is elementary: case splits, products of hypotheses, and identities that `ring`
/// checks. Throws InputError.
std::string coq_text(const std::string& file, const std::string& statement, const std::string& certificate_file,
                     const std::string& certificate);

}  // namespace slipproof
