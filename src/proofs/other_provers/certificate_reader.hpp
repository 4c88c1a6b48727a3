// Certificates (proofs/FORMAT.md) read back. For export alone: what they prove is for the checker to say.
#pragma once

#include <string>

#include "proofs/statement/proof.hpp"

namespace slipproof {

/// The proof in `text`, the content of the certificate `file`. Throws InputError with the first line that is not in the
/// format. Whether hypotheses exist and identities hold is not looked at.
prove::Proof read_certificate(const prove::Statement& statement, const std::string& file, const std::string& text);

}  // namespace slipproof
