#include "report/certificates.hpp"

#include "check/files.hpp"
#include "prove/library.hpp"

namespace slipproof {

void find_certificates(const ClaimsFile& file, VerifyResult& result, const std::filesystem::path& folder) {
  const auto rejection = [](const std::filesystem::path& certificate) {
    return check::check_file(certificate).message;
  };
  for (ClaimResult& claim : result.claims) {
    ClaimProof proof = find_claim_proof(file, file.claims[claim.claim], claim.reading, folder, rejection);
    claim.outdated = std::move(proof.outdated);
    claim.rejections = std::move(proof.rejections);
    if (!proof.proved) continue;
    if (claim.refuted > 0) {
      claim.rejections.push_back(file.claims[claim.claim].id +
                                 ": refuted by a sample, yet its certificates are accepted");
      continue;
    }
    if (claim.undecided > 0) continue;  // it has no value somewhere: statements are not about those bicycles
    claim.verdict = Verdict::holds;
    claim.proved = true;
    for (const std::filesystem::path& certificate : proof.certificates) {
      claim.certificates.push_back(certificate.filename().string());
    }
  }
}

}  // namespace slipproof
