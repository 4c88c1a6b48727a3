#include "report/certificates.hpp"

#include "check/files.hpp"
#include "statements/library.hpp"

namespace slipproof {

namespace {

std::string rejection(const std::filesystem::path& certificate) {
  return check::check_file(certificate).message;
}

/// Takes over what the proof has to say, whatever it proves.
void add_problems(ClaimResult& claim, const ClaimProof& proof) {
  claim.rejections.insert(claim.rejections.end(), proof.rejections.begin(), proof.rejections.end());
  claim.outdated.insert(claim.outdated.end(), proof.outdated.begin(), proof.outdated.end());
}

void name_certificates(ClaimResult& claim, const ClaimProof& proof) {
  for (const std::filesystem::path& certificate : proof.certificates) {
    claim.certificates.push_back(certificate.filename().string());
  }
}

}  // namespace

void find_certificates(const ClaimsFile& file, VerifyResult& result, const std::filesystem::path& folder) {
  for (ClaimResult& claim : result.claims) {
    const Claim& stated = file.claims[claim.claim];
    const ClaimProof proof = find_claim_proof(file, stated, claim.reading, folder, rejection);
    const ClaimProof refutation = find_proof(claim_refutation(file, stated, claim.reading), folder, rejection);
    add_problems(claim, proof);
    add_problems(claim, refutation);
    if (refutation.proved && proof.proved) {
      claim.rejections.push_back(stated.id + ": certificates of it and of its refutation are accepted");
      continue;
    }
    // Samples may all miss what a refutation proves to exist.
    if (refutation.proved && claim.verdict != Verdict::vacuous) claim.verdict = Verdict::refuted;
    if (refutation.proved && claim.verdict == Verdict::refuted) name_certificates(claim, refutation);
    if (!proof.proved) continue;
    if (claim.refuted > 0) {
      claim.rejections.push_back(stated.id + ": refuted by a sample, yet its certificates are accepted");
      continue;
    }
    // A proof about nothing proves nothing: the claim has to be right somewhere.
    if (claim.held == 0 && !stated.is<Exists>()) continue;
    if (claim.undecided > 0) continue;  // it has no value somewhere: statements are not about those bicycles
    claim.verdict = Verdict::holds;
    claim.proved = true;
    name_certificates(claim, proof);
  }
}

}  // namespace slipproof
