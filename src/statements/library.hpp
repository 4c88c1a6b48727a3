// The shipped proofs of a claims file: which certificates prove a claim, and whether they do.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "statements/claim_statements.hpp"

namespace slipproof {

/// Where the statements and certificates of a claims file stand: in `certificates` beside it.
std::filesystem::path certificates_folder(const std::filesystem::path& claims);

/// What stands in the folder for a claim in a reading.
struct ClaimProof {
  bool proved = false;                              ///< all of its statements are, by `certificates`
  std::vector<std::filesystem::path> certificates;  ///< one for each statement of the claim, there or not
  std::vector<std::string> problems;                ///< why not: a missing file, another statement, a rejection
  std::vector<std::string> outdated;                ///< of these: a statement that is there and not the claim's
  std::vector<std::string> rejections;              ///< of these: a certificate that is there and proves nothing
};

/// The checker's objection to a certificate, empty if there is none: check::check_file(...).message.
using CertificateJudge = std::function<std::string(const std::filesystem::path&)>;

/// Whether certificates in `folder` prove all of the statements: NAME.statement there must be the same bytes, and
/// `rejection` of NAME.cert empty.
ClaimProof find_proof(const std::vector<NamedStatement>& statements, const std::filesystem::path& folder,
                      const CertificateJudge& rejection);

/// The same for claim_statements(), so that the claims file cannot say one thing and the proof another.
ClaimProof find_claim_proof(const ClaimsFile& claims, const Claim& claim, Reading reading,
                            const std::filesystem::path& folder, const CertificateJudge& rejection);

}  // namespace slipproof
